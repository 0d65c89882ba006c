#!/usr/bin/env python3
"""The pictures of the README: real view and simulated film, each to its map; and a clip.

usage: overview.py PICTURES_FOLDER FIGURES_FOLDER OUT_FOLDER

PICTURES_FOLDER has what first_page.mjs wrote and real_points.png, real_mesh.png, FIGURES_FOLDER what
acmap_paper_figures wrote. Writes overview.jpg and clip.webp. Needs python3-pil and fonts-dejavu.
"""
import sys
from pathlib import Path

from PIL import Image, ImageChops, ImageDraw, ImageFont

SIZE = (396, 264)  # pixels of a part
GAP, CAPTION = 6, 24
INK = (31, 41, 51)


def part(path, box=None):
    """A picture, or a box of it, that fills its place."""
    image = Image.open(path).convert("RGB")
    if box:
        image = image.crop(box)
    scale = max(SIZE[0] / image.width, SIZE[1] / image.height)
    image = image.resize((round(image.width * scale), round(image.height * scale)), Image.LANCZOS)
    left, top = (image.width - SIZE[0]) // 2, (image.height - SIZE[1]) // 2
    return image.crop((left, top, left + SIZE[0], top + SIZE[1]))


def whole(path):
    """What differs from the background of a picture, in the middle of its place."""
    image = Image.open(path).convert("RGB")
    ground = Image.new("RGB", image.size, image.getpixel((0, image.height - 1)))
    drawn = ImageChops.difference(image, ground).convert("L").point(lambda level: 255 * (level > 8))
    image = image.crop(drawn.getbbox())
    scale = min((SIZE[0] - 12) / image.width, (SIZE[1] - 12) / image.height)
    image = image.resize((round(image.width * scale), round(image.height * scale)), Image.LANCZOS)
    place = Image.new("RGB", SIZE, ground.getpixel((0, 0)))
    place.paste(image, ((SIZE[0] - image.width) // 2, (SIZE[1] - image.height) // 2))
    return place


def sheet(rows):
    width = max(len(row) for row in rows) * (SIZE[0] + GAP) - GAP
    page = Image.new("RGB", (width, len(rows) * (SIZE[1] + CAPTION + GAP) - GAP), "white")
    draw = ImageDraw.Draw(page)
    font = ImageFont.truetype("DejaVuSans.ttf", 14)
    for y, row in enumerate(rows):
        for x, (image, caption) in enumerate(row):
            place = (x * (SIZE[0] + GAP), y * (SIZE[1] + CAPTION + GAP))
            page.paste(image, place)
            draw.text((place[0] + 2, place[1] + SIZE[1] + 3), caption, INK, font)
    return page


def overview(pictures, figures):
    return sheet([
        [(whole(pictures / "real_points.png"), "One view of an office, by a Kinect"),
         (whole(pictures / "real_mesh.png"), "its mesh"),
         (whole(pictures / "real_map.png"), "its map: planes with texture, and details")],
        [(part(figures / "fig2.png", (252, 0, 498, 185)), "Blank walls under random lines (simulated)"),
         (part(pictures / "filmed_inside.png"), "the map of 106 such views, from inside"),
         (whole(pictures / "filmed_map.png"), "and from outside")],
    ])


def clip(pictures, out):
    frames = [Image.open(path).convert("RGB") for path in sorted(pictures.glob("clip_*.png"))]
    frames[0].save(out, save_all=True, append_images=frames[1:], duration=160, loop=0, quality=60, method=6)


def main(pictures, figures, out):
    overview(Path(pictures), Path(figures)).save(Path(out) / "overview.jpg", quality=88, optimize=True)
    clip(Path(pictures), Path(out) / "clip.webp")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
