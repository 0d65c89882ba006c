#!/usr/bin/env python3
"""Writes frames of a 7-Scenes recording in the layout of another program.

    write_layout.py LAYOUT SOURCE TARGET [--frames N]

SOURCE holds frame-000000.color.jpg, .depth.png (millimetres), .pose.txt and
camera-intrinsics.txt. Every layout tells the same points, poses and colours, so that each of
them has to give the same median depth and the same poses. Python's own library suffices.
"""

import argparse
import json
import math
import pathlib
import shutil
import struct
import zlib

FIRST_TIME = 1305031102.0  # seconds
INTERVAL = 1 / 3  # ten frames of 30 Hz


def read_png16(path):
    """Returns width and rows of a grey PNG of 16 bits."""
    data = path.read_bytes()
    width = height = 0
    packed = b""
    at = 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        kind = data[at + 4 : at + 8]
        content = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", content[:10])
            if (bits, color) != (16, 0):
                raise SystemExit(f"{path}: is no grey PNG of 16 bits")
        elif kind == b"IDAT":
            packed += content
        at += 12 + length
    raw = zlib.decompress(packed)
    stride = 2 * width
    above = bytes(stride)
    rows = []
    for row in range(height):
        begin = row * (stride + 1)
        method = raw[begin]
        line = bytearray(raw[begin + 1 : begin + 1 + stride])
        if method == 1:
            for i in range(2, stride):
                line[i] = (line[i] + line[i - 2]) & 255
        elif method == 2:
            for i in range(stride):
                line[i] = (line[i] + above[i]) & 255
        elif method == 3:
            for i in range(stride):
                left = line[i - 2] if i > 1 else 0
                line[i] = (line[i] + (left + above[i]) // 2) & 255
        elif method == 4:
            for i in range(stride):
                left = line[i - 2] if i > 1 else 0
                corner = above[i - 2] if i > 1 else 0
                up = above[i]
                guess = left + up - corner
                a, b, c = abs(guess - left), abs(guess - up), abs(guess - corner)
                best = left if a <= b and a <= c else up if b <= c else corner
                line[i] = (line[i] + best) & 255
        above = bytes(line)
        rows.append(list(struct.unpack(f">{width}H", above)))
    return width, rows


def write_png(path, rows, bits=16):
    """Writes rows of numbers as a grey PNG."""
    width = len(rows[0])
    letter = "H" if bits == 16 else "B"
    raw = b"".join(b"\0" + struct.pack(f">{width}{letter}", *row) for row in rows)

    def chunk(kind, content):
        return (
            struct.pack(">I", len(content))
            + kind
            + content
            + struct.pack(">I", zlib.crc32(kind + content))
        )

    header = struct.pack(">IIBBBBB", width, len(rows), bits, 0, 0, 0, 0)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(raw, 1))
        + chunk(b"IEND", b"")
    )


def write_pgm(path, rows):
    """Writes rows of numbers as a PGM of 16 bits."""
    width = len(rows[0])
    path.write_bytes(
        f"P5\n{width} {len(rows)}\n65535\n".encode()
        + b"".join(struct.pack(f">{width}H", *row) for row in rows)
    )


def scaled(rows, factor):
    return [[min(65535, round(factor * value)) for value in row] for row in rows]


def halved(rows):
    return [row[::2] for row in rows[::2]]


def quaternion(m):
    """qx qy qz qw of a rotation, which may be rounded: from its largest component."""
    trace = m[0][0] + m[1][1] + m[2][2]
    q = [0.0] * 4
    if trace > 0:
        root = math.sqrt(trace + 1)
        q[3] = root / 2
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            q[i] = (m[k][j] - m[j][k]) / (2 * root)
    else:
        i = max(range(3), key=lambda axis: m[axis][axis])
        j, k = (i + 1) % 3, (i + 2) % 3
        root = math.sqrt(m[i][i] - m[j][j] - m[k][k] + 1)
        q[i] = root / 2
        q[3] = (m[k][j] - m[j][k]) / (2 * root)
        q[j] = (m[j][i] + m[i][j]) / (2 * root)
        q[k] = (m[k][i] + m[i][k]) / (2 * root)
    length = math.sqrt(sum(value * value for value in q))
    return [value / length for value in q]


class Frame:
    """A frame of the source; its depth is read when it is asked for."""

    def __init__(self, folder, index, number):
        base = folder / f"frame-{number}"
        self.index = index
        self.time = FIRST_TIME + INTERVAL * index
        self.color = pathlib.Path(f"{base}.color.jpg")
        self.depth_file = pathlib.Path(f"{base}.depth.png")
        self.pose_text = pathlib.Path(f"{base}.pose.txt").read_text()
        self.pose = [
            [float(word) for word in line.split()]
            for line in self.pose_text.splitlines()
            if line.split()
        ]

    def depth(self):
        # 65535 is the source's number for pixels that measured nothing
        return [
            [0 if value == 65535 else value for value in row]
            for row in read_png16(self.depth_file)[1]
        ]

    def tum_row(self):
        place = [self.pose[i][3] for i in range(3)]
        return " ".join(repr(v) for v in [self.time, *place, *quaternion(self.pose)])

    def row(self, size):
        return " ".join(repr(v) for line in self.pose[:size] for v in line)


class Source:
    def __init__(self, folder, count):
        numbers = sorted(
            path.name.split("-")[1].split(".")[0] for path in folder.glob("*.depth.png")
        )[:count]
        self.frames = [Frame(folder, i, number) for i, number in enumerate(numbers)]
        self.camera = [
            [float(word) for word in line.split()]
            for line in (folder / "camera-intrinsics.txt").read_text().splitlines()
        ]


def folders(target, *names):
    for name in names:
        (target / name).mkdir(parents=True, exist_ok=True)
    return [target / name for name in names]


def matrix_text(matrix):
    return "".join(" ".join(repr(value) for value in row) + "\n" for row in matrix)


def orb_slam(source, target):
    """rgb/, depth/ at 5000 in a metre, associations.txt, groundtruth.txt."""
    rgb, depth = folders(target, "rgb", "depth")
    rows = []
    for frame in source.frames:
        name = f"{frame.time:.6f}"
        shutil.copy(frame.color, rgb / f"{name}.jpg")
        write_png(depth / f"{name}.png", scaled(frame.depth(), 5))
        rows.append(f"{name} rgb/{name}.jpg {name} depth/{name}.png\n")
    (target / "associations.txt").write_text("".join(rows))
    poses = "".join(frame.tum_row() + "\n" for frame in source.frames)
    (target / "groundtruth.txt").write_text(poses)
    camera = source.camera
    (target / "calibration.txt").write_text(
        f"{camera[0][0]} {camera[1][1]} {camera[0][2]} {camera[1][2]}\n"
    )


def times(source, target):
    """rgb/ and depth/ whose names are times; one image of each kind is lost."""
    rgb, depth = folders(target, "rgb", "depth")
    lost_color, lost_depth = 2, 5
    for frame in source.frames:
        if frame.index != lost_color:
            shutil.copy(frame.color, rgb / f"{frame.time + 0.004:.6f}.jpg")
        if frame.index != lost_depth:
            write_png(depth / f"{frame.time:.6f}.png", frame.depth())
    poses = "".join(frame.tum_row() + "\n" for frame in source.frames)
    (target / "groundtruth.txt").write_text(poses)
    open3d_camera(source, target, 1)
    for name in (".DS_Store", "Thumbs.db", "README.txt"):
        (depth / name).write_text("nothing\n")
    (rgb / "._hidden.jpg").write_text("nothing\n")


def open3d_camera(source, target, factor):
    """The camera as Open3D writes it, of images that are larger by a factor."""
    camera = source.camera
    center = [(camera[i][2] + 0.5) * factor - 0.5 for i in range(2)]
    matrix = [camera[0][0] * factor, 0, 0, 0, camera[1][1] * factor, 0, *center, 1]
    text = {"width": 640 * factor, "height": 480 * factor, "intrinsic_matrix": matrix}
    (target / "camera_intrinsic.json").write_text(json.dumps(text))


def open3d(source, target):
    """color/, Depth/ as PGM, trajectory.log; the camera is that of images twice as large."""
    color, depth = folders(target, "color", "Depth")
    log = []
    for frame in source.frames:
        shutil.copy(frame.color, color / f"{frame.index:05d}.JPG")
        write_pgm(depth / f"{frame.index}.pgm", frame.depth())
        log.append(f"{frame.index} {frame.index} {frame.index + 1}\n")
        log.append(matrix_text(frame.pose))
    (target / "trajectory.log").write_text("".join(log))
    open3d_camera(source, target, 2)


def scannet(source, target):
    """color/, depth/ of half the size, pose/ with a lost one, intrinsic/."""
    color, depth, pose, intrinsic = folders(
        target, "color", "depth", "pose", "intrinsic"
    )
    lost = 3
    for frame in source.frames:
        shutil.copy(frame.color, color / f"{frame.index}.jpg")
        write_png(depth / f"{frame.index}.png", halved(frame.depth()))
        text = "-inf -inf -inf -inf\n" * 4 if frame.index == lost else frame.pose_text
        (pose / f"{frame.index}.txt").write_text(text)
    wide = [row + [0.0] for row in source.camera] + [[0.0, 0.0, 0.0, 1.0]]
    small = [[value / 2 for value in row] for row in wide[:2]] + wide[2:]
    unit = [[float(i == k) for k in range(4)] for i in range(4)]
    (intrinsic / "intrinsic_color.txt").write_text(matrix_text(wide))
    (intrinsic / "intrinsic_depth.txt").write_text(matrix_text(small))
    (intrinsic / "extrinsic_color.txt").write_text(matrix_text(unit))
    (intrinsic / "extrinsic_depth.txt").write_text(matrix_text(unit))


def replica(source, target):
    """results/, traj.txt, cam_params.json with the scale of the depths."""
    (results,) = folders(target, "results")
    for frame in source.frames:
        shutil.copy(frame.color, results / f"frame{frame.index:06d}.jpg")
        write_png(
            results / f"depth{frame.index:06d}.png", scaled(frame.depth(), 6.5535)
        )
    rows = "".join(frame.row(4) + "\n" for frame in source.frames)
    (target / "traj.txt").write_text(rows)
    camera = source.camera
    text = {
        "camera": {
            "w": 640,
            "h": 480,
            "fx": camera[0][0],
            "fy": camera[1][1],
            "cx": camera[0][2],
            "cy": camera[1][2],
            "scale": 6553.5,
        }
    }
    (target / "cam_params.json").write_text(json.dumps(text))


def stray(source, target):
    """depth/, confidence/, odometry.csv, camera_matrix.csv, and rgb/ for the video."""
    depth, confidence, rgb = folders(target, "depth", "confidence", "rgb")
    rows = ["timestamp, frame, x, y, z, qx, qy, qz, qw\n"]
    for frame in source.frames:
        small = halved(frame.depth())
        write_png(depth / f"{frame.index:06d}.png", small)
        write_png(
            confidence / f"{frame.index:06d}.png",
            [[2 if value else 0 for value in row] for row in small],
            8,
        )
        shutil.copy(frame.color, rgb / f"{frame.index:06d}.jpg")
        place = [frame.pose[i][3] for i in range(3)]
        values = [frame.time, f"{frame.index:06d}", *place, *quaternion(frame.pose)]
        rows.append(", ".join(str(value) for value in values) + "\n")
    (target / "odometry.csv").write_text("".join(rows))
    (target / "camera_matrix.csv").write_text(
        "".join(", ".join(repr(value) for value in row) + "\n" for row in source.camera)
    )


def record3d(source, target):
    """rgb/, depth/, metadata.json with poses of a camera with y up and z backward."""
    rgb, depth = folders(target, "rgb", "depth")
    poses = []
    for frame in source.frames:
        shutil.copy(frame.color, rgb / f"{frame.index}.jpg")
        write_png(depth / f"{frame.index}.png", frame.depth())
        x, y, z, w = quaternion(frame.pose)
        turned = [w, z, -y, -x]  # times half a turn about x
        poses.append([*turned, *(frame.pose[i][3] for i in range(3))])
    camera = source.camera
    matrix = [camera[row][column] for column in range(3) for row in range(3)]
    text = {"w": 640, "h": 480, "fps": 30, "K": matrix, "poses": poses}
    (target / "metadata.json").write_text(json.dumps(text))


def points_of(frame, camera):
    """Points of every fourth pixel in the frame of the camera, metres."""
    points = []
    for row, line in enumerate(frame.depth()[::4]):
        for column, value in enumerate(line[::4]):
            if value:
                z = value / 1000
                points.append(
                    (
                        z * (4 * column - camera[0][2]) / camera[0][0],
                        z * (4 * row - camera[1][2]) / camera[1][1],
                        z,
                    )
                )
    return points


def kitti_rows(source):
    return "".join(frame.row(3) + "\n" for frame in source.frames)


def ply(source, target):
    """000000.ply and so on with KITTI's poses.txt."""
    for frame in source.frames:
        points = points_of(frame, source.camera)
        header = (
            f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
            "property float x\nproperty float y\nproperty float z\nend_header\n"
        )
        (target / f"{frame.index:06d}.ply").write_bytes(
            header.encode() + b"".join(struct.pack("<3f", *p) for p in points)
        )
    (target / "poses.txt").write_text(kitti_rows(source))


def pcd(source, target):
    """cloud_0.pcd, with as many digits as the number needs, and KITTI's poses.txt."""
    for frame in source.frames:
        points = points_of(frame, source.camera)
        header = (
            "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
            f"WIDTH {len(points)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
            f"POINTS {len(points)}\nDATA binary\n"
        )
        (target / f"cloud_{frame.index}.pcd").write_bytes(
            header.encode() + b"".join(struct.pack("<3f", *p) for p in points)
        )
    (target / "poses.txt").write_text(kitti_rows(source))


def kitti(source, target):
    """velodyne/*.bin of a scanner with x ahead, poses.txt of the camera, calib.txt."""
    (scans,) = folders(target, "velodyne")
    for frame in source.frames:
        (scans / f"{frame.index:06d}.bin").write_bytes(
            b"".join(
                struct.pack("<4f", z, -x, -y, 0.5)
                for x, y, z in points_of(frame, source.camera)
            )
        )
    (target / "poses.txt").write_text(kitti_rows(source))
    times = "".join(f"{INTERVAL * frame.index:e}\n" for frame in source.frames)
    (target / "times.txt").write_text(times)
    projection = "718.856 0 607.1928 0 0 718.856 185.2157 0 0 0 1 0"
    (target / "calib.txt").write_text(
        "".join(f"P{i}: {projection}\n" for i in range(4))
        + "Tr: 0 -1 0 0 0 0 -1 0 1 0 0 0\n"
    )


LAYOUTS = {
    function.__name__: function
    for function in (
        orb_slam,
        times,
        open3d,
        scannet,
        replica,
        stray,
        record3d,
        ply,
        pcd,
        kitti,
    )
}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("layout", choices=LAYOUTS)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("target", type=pathlib.Path)
    parser.add_argument("--frames", type=int, default=8)
    options = parser.parse_args()
    options.target.mkdir(parents=True, exist_ok=True)
    LAYOUTS[options.layout](Source(options.source, options.frames), options.target)


if __name__ == "__main__":
    main()
