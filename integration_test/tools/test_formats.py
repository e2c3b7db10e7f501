# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""How meshes are read: formats, names without extension, pipes."""

import os
import threading

import pytest

from mesh_files import OffFile, labels
from records import read_record
from tool import names_in

TETRAHEDRA = ["tetrahedron.off", "tetrahedron.obj", "tetrahedron.ply", "tetrahedron.stl",
              "tetrahedron_binary.stl", "tetrahedron.ts", "tetrahedron.off.gz", "no_keyword.off",
              "more_numbers_than_in_header.ply", "numbers_not_in_lines.ply"]


@pytest.mark.parametrize("keyword", "COFF NOFF STOFF NCOFF CSTOFF NSTOFF STNOFF NCSTOFF CNSTOFF "
                                    "STNCOFF".split())
def test_keyword_of_off(segment, tetrahedron, tmp_path, keyword):
    (tmp_path / "a.off").write_text(keyword + "\n" + tetrahedron.read_text().split("\n", 1)[1])
    segment("a.off")


@pytest.mark.parametrize("keyword", ["CCOFF", "NCNOFF", "STCSTOFF", "SOFF", "XOFF"])
def test_unknown_keyword_of_off(segment, tetrahedron, tmp_path, keyword):
    (tmp_path / "a.off").write_text(keyword + "\n" + tetrahedron.read_text().split("\n", 1)[1])
    segment.refuses("a.off", message=f"'{keyword}'")


@pytest.mark.parametrize("name, message", [
    ("word_in_face.obj", "word_in_face.obj: line 6: 'x' is no corner of a face"),
    ("incomplete_vertex.off", "incomplete_vertex.off: line 4: "),
    ("word_for_number.stl", "word_for_number.stl: line 5: '1,0' is no coordinate"),
    ("solid_truncated_binary.stl",
     "solid_truncated_binary.stl: announces 4 facets, and ends after 1"),
    ("vertex_twice.ts", "vertex_twice.ts: line 5: there is a vertex 2 already"),
    ("missing_vertex.ts", "missing_vertex.ts: line 6: names vertex 4, "),
    ("utf_16.off", "UTF-16"),
    ("range_grid.ply", "range grid"),
    ("fewer_numbers_than_in_header.ply", "line 11: has fewer numbers than the header says"),
    ("more_faces_than_announced.off", "line 11: goes on behind the 4 vertices and 4 faces that it announces: '3 0 1 2'"),
    ("more_faces_than_announced.ply", "line 18: goes on behind what the header announces"),
    ("git_lfs_pointer.stl", "is a pointer of Git LFS"),
    ("no_such_file.off", "no_such_file.off: "),
])
def test_message_on_a_bad_mesh(segment, data, name, message):
    segment.refuses(data / name, message=message)


@pytest.mark.parametrize("name", ["missing", "missing/", "missing.xyz", "missing/a.off"])
def test_mesh_that_is_not_there(segment, name):
    segment.refuses(name, message=f"{name}: cannot be opened: No such file or directory")


def test_empty_file_of_unknown_format(segment, tmp_path):
    (tmp_path / "empty.xyz").touch()
    segment.refuses("empty.xyz", message="empty.xyz: is in no known format")


def test_name_that_begins_with_a_dash(segment, tetrahedron, tmp_path):
    (tmp_path / "-dash.off").write_bytes(tetrahedron.read_bytes())
    result = segment.run("-dash.off")
    assert result.code != 0
    assert result.err.count("\n") == 1
    assert "; the file -dash.off is named by ./-dash.off" in result.err
    segment("./-dash.off")
    segment("--", "-dash.off")


@pytest.mark.parametrize("name, message", [
    ("two_surfaces.ts", "2 faces, 2 segments"),
    ("atoms.ts", "4 faces, 1 segment,"),
])
def test_number_of_faces(segment, data, name, message):
    assert message in segment(data / name).out


@pytest.mark.parametrize("name, message, key, number", [
    ("facet_of_two_points.stl", "1 degenerate face has the label of a neighbour",
     "degenerate_faces", 1),
    ("double_sided.off", "6 duplicate faces have that of the first", "duplicate_faces", 6),
    ("wall_between_solids.off", "", "components", 2),
])
def test_repairs(segment, data, name, message, key, number):
    assert message in segment(data / name).err
    assert segment.record(data / name)["surface"][key] == number


def test_labels_fit_a_repaired_mesh(segment, evaluate, data):
    mesh = data / "facet_of_two_points.stl"
    segment(mesh, "-k", 2, "-o", "a.seg")
    evaluate(mesh, "a.seg", "a.seg")


def write_off(path, points, faces):
    path.write_text("\n".join([f"OFF\n{len(points)} {len(faces)} 0", *points, *faces]) + "\n")


def test_repair_keeps_labels_of_a_good_mesh(segment, teddy, tmp_path):
    """A mesh without faults is not repaired; one with a duplicate face or an unused point is."""
    lines = list(filter(None, teddy.read_text().splitlines()))
    number_of_points = int(lines[1].split()[0])
    points, faces = lines[2:2 + number_of_points], lines[2 + number_of_points:]
    write_off(tmp_path / "good.off", points, faces)
    write_off(tmp_path / "twice.off", points, faces + faces[-1:])
    write_off(tmp_path / "unused.off", points + ["7 7 7"], faces)
    for name in ("good", "twice", "unused"):
        result = segment(f"{name}.off", "-k", 4, "-o", f"{name}.seg")
        assert name != "twice" or "1 duplicate face has that of the first" in result.err
    good = labels(tmp_path / "good.seg")
    assert labels(tmp_path / "twice.seg")[:-1] == good
    assert labels(tmp_path / "unused.seg") == good


@pytest.mark.parametrize("name", TETRAHEDRA)
def test_format_by_how_the_file_begins(segment, data, tmp_path, name):
    content = (data / name).read_bytes()
    (tmp_path / "nameless").write_bytes(content)
    segment("nameless", "-k", 2)
    with (data / name).open("rb") as file:
        segment("/dev/stdin", "-k", 2, stdin=file)
    end_to_read, end_to_write = os.pipe()
    os.write(end_to_write, content)
    os.close(end_to_write)
    segment(f"/dev/fd/{end_to_read}", "-k", 2, pass_fds=[end_to_read])
    os.close(end_to_read)


def test_labels_to_the_standard_output(segment, teddy, tmp_path):
    segment(teddy, "-k", 4, "-o", "a.seg")
    assert segment(teddy, "-k", 4, "-o", "-").out == (tmp_path / "a.seg").read_text()


@pytest.mark.parametrize("name", TETRAHEDRA + ["smallest_byte_first_binary.off",
                                               "counts_behind_keyword.off"])
def test_pipe(segment, data, name):
    result = segment("-", *"-k 2 -o -".split(), input=(data / name).read_bytes())
    assert len(result.out.splitlines()) == 4


def test_coordinates_out_of_range_in_stl(segment, data, tmp_path):
    """One that is too small is 0, as is -0; one that is too large is none."""
    text = (data / "tetrahedron.stl").read_text()
    for word in ("1e-400", "-0"):
        (tmp_path / "small.stl").write_text(text.replace("vertex 0 0 0", f"vertex 0 {word} 0", 1))
        segment("small.stl", "-o", "small.off")
        assert len(OffFile(tmp_path / "small.off").points) == 4
    (tmp_path / "large.stl").write_text(text.replace("vertex 0 0 0", "vertex 0 1e400 0", 1))
    segment.refuses("large.stl", message="line 4: '1e400' is no coordinate")


@pytest.mark.parametrize("extension", ["obj", "ply", "stl"])
def test_pipe_of_a_larger_mesh(segment, make_mesh, tmp_path, extension):
    make_mesh("chair", f"a.{extension}", "--faces", 1000)
    content = (tmp_path / f"a.{extension}").read_bytes()
    assert len(segment("-", *"-k 2 -o -".split(), input=content).out.splitlines()) >= 1000


def test_named_pipe(segment, tetrahedron, tmp_path):
    pipe = tmp_path / "pipe.off"
    os.mkfifo(pipe)
    writer = threading.Thread(target=lambda: pipe.write_bytes(tetrahedron.read_bytes()))
    writer.start()
    segment(pipe, "-k", 2)
    writer.join()


def test_empty_pipe(segment):
    result = segment.run("-", input=b"")
    assert result.code != 0
    assert result.err.count("\n") == 1 and "-: is empty" in result.err


def test_3mf(segment, data, tmp_path, libraries):
    """An object within a component within a component, moved and scaled."""
    mesh = data / "three_tetrahedra.3mf"
    if "lib3mf" not in libraries:
        segment.refuses(mesh, "-o", "a.off", message="lib3mf")
        return
    segment(mesh, "-o", "a.off")
    written = OffFile(tmp_path / "a.off")
    assert (len(written.points), len(written.faces)) == (12, 12)
    for point in ([0, 0, 8], [2, 10, 0], [12, 10, 0], [10, 12, 0]):
        assert point in written.points.tolist()


def test_vtp(segment, data, tmp_path, libraries):
    """Vertices and lines are no faces, strips are some."""
    mesh = data / "strips.vtp"
    if "vtk" not in libraries:
        segment.refuses(mesh, "-o", "a.off", message="VTK")
        return
    assert "turned over" not in segment(mesh, "-o", "a.off").err
    assert len(OffFile(tmp_path / "a.off").faces) == 4
    assert len(segment("-", *"-k 2 -o -".split(), input=mesh.read_bytes()).out.splitlines()) == 4


@pytest.mark.parametrize("array", ["CellData", "PointData"])
@pytest.mark.parametrize("values", ["0 0 1", "0 0 1 x", ""])
def test_vtp_with_a_short_array(segment, tmp_path, libraries, array, values):
    if "vtk" not in libraries:
        pytest.skip("VTK was not found")
    (tmp_path / "a.vtp").write_text(
        '<VTKFile type="PolyData" version="0.1"><PolyData>'
        '<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="4">'
        f'<{array}><DataArray type="Int32" Name="segment" format="ascii">{values}</DataArray></{array}>'
        '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>'
        '<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 2 1 0 1 3 1 2 3 0 3 2</DataArray>'
        '<DataArray type="Int32" Name="offsets" format="ascii">3 6 9 12</DataArray></Polys>'
        '</Piece></PolyData></VTKFile>')
    segment.refuses("a.vtp", "-o", "a.seg", message="is not a well-formed VTP file")
    assert names_in(tmp_path) == ["a.vtp"]


def test_vtp_is_read_as_it_was_written(segment, teddy, tmp_path, libraries):
    if "vtk" not in libraries:
        pytest.skip("VTK was not found")
    segment(teddy, *"-k 4 -o a.vtp -o a.seg".split())
    segment("a.vtp", *"-k 4 -o b.seg".split())
    assert labels(tmp_path / "a.seg") == labels(tmp_path / "b.seg")
