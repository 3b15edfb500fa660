"""Writes the meshes of this folder. Needs numpy, pillow, trimesh, plyfile, meshio, pygltflib; see README.md.

The surface is a patch of 4 x 3 vertices: vertex i + 4 j lies at (i / 2, j / 4, i j / 8), its texture coordinate is
(i / 4, j / 4) with v up, its normal (0, 0, 1) before the corners of cells are lifted. Cell (i, j) is the quad
(a, a + 1, a + 5, a + 4) with a = i + 4 j, or the triangles (a, a + 1, a + 5) and (a, a + 5, a + 4).
"""

import base64
import struct

import meshio
import numpy as np
import plyfile
import pygltflib
import trimesh

I, J = (grid.ravel() for grid in np.meshgrid(np.arange(4), np.arange(3)))
POSITIONS = np.stack([I / 2, J / 4, I * J / 8], axis=1)
UVS = np.stack([I / 4, J / 4], axis=1)
NORMALS = np.tile([0.0, 0.0, 1.0], (12, 1))
CELLS = [i + 4 * j for j in range(2) for i in range(3)]
QUADS = np.array([[a, a + 1, a + 5, a + 4] for a in CELLS])
TRIANGLES = np.array([t for a in CELLS for t in ([a, a + 1, a + 5], [a, a + 5, a + 4])])


def write(name, data):
    with open(name, "wb") as file:
        file.write(data.encode() if isinstance(data, str) else data)


def with_trimesh():
    visual = trimesh.visual.TextureVisuals(uv=UVS)
    mesh = trimesh.Trimesh(POSITIONS, TRIANGLES, vertex_normals=NORMALS, process=False, visual=visual)
    text, _ = trimesh.exchange.obj.export_obj(mesh, include_normals=True, return_texture=True)
    write("trimesh.obj", text)
    write("trimesh.ply", mesh.export(file_type="ply"))
    write("trimesh_text.ply", mesh.export(file_type="ply", encoding="ascii"))
    write("trimesh.glb", mesh.export(file_type="glb"))
    files = trimesh.exchange.gltf.export_gltf(mesh, merge_buffers=True)
    write("trimesh.gltf", files["model.gltf"].replace(b"gltf_buffer.bin", b"trimesh%2Dbuffer.bin"))
    write("trimesh-buffer.bin", files["gltf_buffer.bin"])


def with_plyfile():
    kinds = [("confidence", "u1"), ("x", "f8"), ("y", "f8"), ("z", "f8"), ("s", "f4"), ("t", "f4"), ("nx", "f4"), ("ny", "f4"), ("nz", "f4")]
    # An offset of 1e7, which f32 would round.
    rows = [(7, x + 1e7, y, z, s, t, *n) for (x, y, z), (s, t), n in zip(POSITIONS, UVS, NORMALS)]
    vertices = plyfile.PlyElement.describe(np.array(rows, kinds), "vertex")
    lists = np.array([(3, np.arange(k, dtype="f8")) for k in range(3)], [("id", "i2"), ("weights", "O")])
    other = plyfile.PlyElement.describe(lists, "other", val_types={"weights": "f8"}, len_types={"weights": "u2"})
    faces = np.array([(q.astype("u2"), 5) for q in QUADS], [("vertex_index", "O"), ("material", "i4")])
    faces = plyfile.PlyElement.describe(faces, "face", val_types={"vertex_index": "u2"}, len_types={"vertex_index": "i4"})
    for name, options in (("big", {"byte_order": ">"}), ("little", {"byte_order": "<"}), ("text", {"text": True})):
        # The faces come first: a file may say so.
        ply = plyfile.PlyData([faces, other, vertices], comments=["elements in an unusual order"], **options)
        ply.write(f"plyfile_{name}.ply")


def with_meshio():
    mesh = meshio.Mesh(POSITIONS, [("quad", QUADS)], point_data={"obj:vt": UVS, "obj:vn": NORMALS})
    meshio.write("meshio.obj", mesh)
    meshio.write("meshio.ply", meshio.Mesh(POSITIONS.astype("f4"), [("quad", QUADS.astype("i4"))]), binary=True)


def gltf(name, parts, accessors, primitive, **top):
    """A .gltf of one primitive, its buffer in base64; parts are arrays, one buffer view each."""
    data, views = b"", []
    for part in parts:
        data += bytes(-len(data) % 4)
        stride = part.strides[0] if part.ndim == 2 and part.shape[1] > 1 else None
        views.append(pygltflib.BufferView(buffer=0, byteOffset=len(data), byteLength=part.nbytes, byteStride=stride))
        data += part.tobytes()
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    document = pygltflib.GLTF2(
        asset=pygltflib.Asset(version="2.0"),
        buffers=[pygltflib.Buffer(byteLength=len(data), uri=uri)],
        bufferViews=views,
        accessors=accessors,
        meshes=[pygltflib.Mesh(name="patch", primitives=[pygltflib.Primitive(**primitive)])],
        **top,
    )
    document.save_json(name)


def with_pygltflib():
    accessor = pygltflib.Accessor
    attributes = pygltflib.Attributes
    low = POSITIONS.min(axis=0).tolist()
    high = POSITIONS.max(axis=0).tolist()
    uvs = np.stack([UVS[:, 0], 1 - UVS[:, 1]], axis=1)
    # Two rows of cells in one strip, joined by triangles without area.
    strip = np.array([4, 0, 5, 1, 6, 2, 7, 3, 3, 8, 8, 4, 9, 5, 10, 6, 11, 7], "u1")
    parts = [POSITIONS.astype("f4"), (uvs * 65535 + 0.5).astype("u2"), strip]
    accessors = [
        accessor(bufferView=0, componentType=5126, count=12, type="VEC3", min=low, max=high),
        accessor(bufferView=1, componentType=5123, count=12, type="VEC2", normalized=True),
        accessor(bufferView=2, componentType=5121, count=len(strip), type="SCALAR"),
    ]
    primitive = {"attributes": attributes(POSITION=0, TEXCOORD_0=1), "indices": 2, "mode": 5}
    gltf("pygltflib_strip.gltf", parts, accessors, primitive)

    # Positions in eighths of 16-bit integers, rows padded to 8 bytes; normals in signed bytes, padded to 4.
    eighths = np.zeros((12, 4), "i2")
    eighths[:, :3] = POSITIONS * 8
    normals = np.zeros((12, 4), "i1")
    normals[:, 2] = 127
    parts = [eighths, normals, TRIANGLES.astype("u2").ravel()]
    accessors = [
        accessor(bufferView=0, componentType=5122, count=12, type="VEC3", min=[0, 0, 0], max=[12, 4, 6]),
        accessor(bufferView=1, componentType=5120, count=12, type="VEC3", normalized=True),
        accessor(bufferView=2, componentType=5123, count=36, type="SCALAR"),
    ]
    primitive = {"attributes": attributes(POSITION=0, NORMAL=1), "indices": 2}
    needed = ["KHR_mesh_quantization"]
    gltf("pygltflib_quantised.gltf", parts, accessors, primitive, extensionsUsed=needed, extensionsRequired=needed)

    # A flat patch whose heights sparse values give.
    flat = POSITIONS.astype("f4") * [1, 1, 0]
    lifted = np.flatnonzero(POSITIONS[:, 2])
    parts = [flat.astype("f4"), lifted.astype("u1"), POSITIONS[lifted].astype("f4"), TRIANGLES.astype("u4").ravel()]
    sparse = pygltflib.Sparse(
        count=len(lifted),
        indices=pygltflib.AccessorSparseIndices(bufferView=1, componentType=5121),
        values=pygltflib.AccessorSparseValues(bufferView=2),
    )
    accessors = [
        accessor(bufferView=0, componentType=5126, count=12, type="VEC3", min=low, max=high, sparse=sparse),
        accessor(bufferView=3, componentType=5125, count=36, type="SCALAR"),
    ]
    gltf("pygltflib_sparse.gltf", parts, accessors, {"attributes": attributes(POSITION=0), "indices": 1})


with_trimesh()
with_plyfile()
with_meshio()
with_pygltflib()
