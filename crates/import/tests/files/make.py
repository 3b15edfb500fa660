"""Writes the files of this folder with software other than ours: numpy, Pillow, tifffile (imagecodecs), OpenEXR.

    pip install numpy pillow tifffile imagecodecs OpenEXR && python make.py

Small maps are 7 x 5 texels, i = 7 * row + column: u8 = 7 i, u16 = 1871 i, floats = 0.375 i - 3.
Larger ones, which compressors do shrink, are 64 x 48 in steps: (column // 8 + 2 (row // 8)) / 8 - 3, and 24 x 20 for
LZW: (column + 2 row) / 8 - 3. All values are exact in f16.
"""

import struct
import zlib

import numpy as np
import OpenEXR
import tifffile
from PIL import Image

i = np.arange(35).reshape(5, 7)
u8, u16, f32 = (i * 7).astype("u1"), (i * 1871).astype("u2"), (i * 0.375 - 3).astype("f4")
steps = (np.add.outer(2 * (np.arange(48) // 8), np.arange(64) // 8) / 8 - 3).astype("f4")
ramp = (np.add.outer(2 * np.arange(20), np.arange(24)) / 8 - 3).astype("f4")


def png(name, bits, interlace, rows):
    """Pillow writes neither four bits of grey nor interlaced files."""
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", 7, 5, bits, 0, 0, 0, interlace)
    data = zlib.compress(b"".join(b"\0" + row for row in rows))
    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


Image.fromarray(u16).save("grey16.png")
Image.fromarray(u8).convert("P").save("palette_grey.png", optimize=True)
Image.fromarray((i % 3 == 0)).save("grey1.png")
png("grey4.png", 4, 0, [bytes(int(h, 16) for h in [f"{a:x}{b:x}" for a, b in (r[0:2], r[2:4], r[4:6], (r[6], 0))]) for r in i % 16])
passes = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]
png("interlaced16.png", 16, 1, [r.astype(">u2").tobytes() for x, y, dx, dy in passes for r in u16[y::dy, x::dx] if r.size])

tile = dict(tile=(16, 16))
tifffile.imwrite("f32_tiled_lzw_p3.tif", f32, compression="lzw", predictor=3, **tile)
tifffile.imwrite("f32_big_deflate_p3.tif", f32, bigtiff=True, compression="zlib", predictor=3, byteorder=">", **tile)
tifffile.imwrite("ramp_tiled_lzw.tif", ramp, compression="lzw", **tile)
tifffile.imwrite("u16_lzw_p2.tif", u16, compression="lzw", predictor=2, rowsperstrip=2)
tifffile.imwrite("u8_packbits.tif", u8, compression="packbits")
tifffile.imwrite("f16_be.tif", f32.astype("f2"), byteorder=">")
planes = np.stack([u8, u8, u8, 255 - u8])
rgb = dict(photometric="rgb", planarconfig="separate", extrasamples=["unassalpha"])
tifffile.imwrite("rgba_planes_tiled.tif", planes, compression="lzw", **rgb, **tile)
holes = f32.copy()
holes[1, 2] = holes[4, 6] = -9999
tifffile.imwrite("gdal_nodata.tif", holes, extratags=[(42113, "s", 0, "-9999", True)])
tifffile.imwrite("zstd.tif", f32, compression="zstd")


def exr(name, channels, compression, **header):
    header = {"type": OpenEXR.scanlineimage, "compression": compression} | header
    with OpenEXR.File(header, channels) as file:
        file.write(name)


half = steps.astype("f2")
for name, rows in {"RLE": 16, "ZIP": 48, "PIZ": 48, "PXR24": 48, "DWAA": 48, "B44": 8}.items():
    exr(f"half_{name.lower()}.exr", {"Y": half[:rows]}, getattr(OpenEXR, name + "_COMPRESSION"))
exr("half_dwaa_raw.exr", {"Y": f32.astype("f2")}, OpenEXR.DWAA_COMPRESSION)
exr("f32_piz.exr", {"height": steps}, OpenEXR.PIZ_COMPRESSION)
exr("tiled.exr", {"Y": f32}, OpenEXR.ZIP_COMPRESSION, type=OpenEXR.tiledimage, tiles=OpenEXR.TileDescription())
exr("rgb_grey.exr", {c: f32.astype("f2") for c in "RGB"}, OpenEXR.ZIP_COMPRESSION)
exr("window.exr", {"Y": f32}, OpenEXR.ZIPS_COMPRESSION, dataWindow=((3, -2), (9, 2)), displayWindow=((0, 0), (19, 19)))
exr("u32.exr", {"id": u16.astype("u4") * 65537}, OpenEXR.RLE_COMPRESSION)
part = lambda name, channels: OpenEXR.Part({"type": OpenEXR.scanlineimage, "compression": OpenEXR.ZIP_COMPRESSION}, channels, name)
with OpenEXR.File([part("flow", {"U": -f32, "V": f32}), part("relief", {"Y": f32})]) as file:
    file.write("parts.exr")

np.save("f32.npy", f32)
np.save("f64_fortran_be.npy", np.asfortranarray(f32.astype(">f8")))
np.save("i16.npy", (u16.astype(int) - 32000).astype("<i2"))
np.save("i64.npy", i)
