#!/usr/bin/env python3
"""The README's picture: from light to textured planes, cut out of the paper's figures.

usage: overview.py FIGURES_FOLDER OUT.png    the folder that acmap_paper_figures wrote
needs python3-pil
"""
import sys
from pathlib import Path

from PIL import Image

SIZE = (246, 185)  # pixels of a part
GAP = 6


def parts(folder):
    acquisition = Image.open(folder / "fig2.png").convert("RGB")
    fused = acquisition.crop((0, 382, 329, 629))
    return [
        acquisition.crop((0, 0, 246, 185)),    # a blank wall
        acquisition.crop((252, 0, 498, 185)),  # under a pattern
        fused,                                 # disparities of ten patterns
        Image.open(folder / "fig7.png").convert("RGB"),
        Image.open(folder / "fig8.png").convert("RGB"),
    ]


def main(folder, out):
    images = [part.resize(SIZE, Image.LANCZOS) for part in parts(Path(folder))]
    sheet = Image.new("RGB", (len(images) * (SIZE[0] + GAP) - GAP, SIZE[1]), "white")
    for place, image in enumerate(images):
        sheet.paste(image, (place * (SIZE[0] + GAP), 0))
    sheet.save(out, optimize=True)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
