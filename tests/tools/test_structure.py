# SPDX-License-Identifier: LGPL-2.1-or-later
"""The house rules hold on this tree, and the checker finds each kind of fault on a small one."""

import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

import header_names
import stages
import structure

ROOT = Path(__file__).resolve().parents[2]
LICENCE = f"// {structure.SPDX}\n"
CMAKE = f"""# {structure.SPDX}
mq_module(base)
mq_module(geometry mq_base)
mq_module(mesh mq_base)
mq_module(triangulate mq_mesh mq_geometry)
target_link_libraries(mq_occt PUBLIC mq_geometry TKernel)
"""
GOOD = {
    "CMakeLists.txt": CMAKE,
    "src/base/error.h": LICENCE,
    "src/geometry/model.h": LICENCE + '#include "base/error.h"\n',
    "src/geometry/occt/shape.cpp": LICENCE + '#include "geometry/model.h"\n#include <TopoDS.hxx>\n',
    "src/mesh/mesh.h": LICENCE + '#include "base/error.h"\n',
    "src/triangulate/refine.cpp": LICENCE + '#include "mesh/mesh.h"\n#include "base/error.h"\n',
}


class HouseRules(unittest.TestCase):
    """One test a rule on the tree itself."""

    def assert_kept(self, check):
        faults = check(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_arrows_point_down(self):
        self.assert_kept(structure.check_arrows)

    def test_the_picture_shows_them(self):
        loader = SourceFileLoader("architecture_picture", str(ROOT / "tools" / "architecture_picture"))
        picture = module_from_spec(spec_from_loader(loader.name, loader))
        loader.exec_module(picture)
        self.assertEqual(picture.drawn(), picture.PICTURE.read_text(encoding="utf-8"), "run tools/architecture_picture")

    def test_includes_follow_the_arrows(self):
        self.assert_kept(structure.check_includes)

    def test_namespaces_are_modules(self):
        self.assert_kept(structure.check_namespaces)

    def test_python_imports(self):
        self.assert_kept(structure.check_python_imports)

    def test_texts(self):
        self.assert_kept(structure.check_texts)

    def test_functions_fit_on_a_screen(self):
        self.assert_kept(structure.check_functions)

    def test_folders_are_stages(self):
        self.assert_kept(stages.check_folders)

    def test_includes_go_to_lower_stages(self):
        self.assert_kept(stages.check_stage_includes)

    def test_headers_declare_what_their_names_say(self):
        self.assert_kept(header_names.check)

    def test_tests_mirror_the_folders(self):
        self.assert_kept(stages.check_tests_mirror)

    def test_pairs_with_tests_of_their_name(self):
        self.assert_kept(stages.check_tested)


class Checker(unittest.TestCase):
    """The checker itself, on temporary trees."""

    def faults(self, check, **changes):
        """Faults of the good tree with files replaced; `__` in a name stands for a slash."""
        files = dict(GOOD)
        for name, text in changes.items():
            files[name.replace("__", "/").replace("_dot_", ".")] = text
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return check(Path(folder))

    def test_header_without_its_name(self):
        text = LICENCE + "void grow(double length);\n"
        self.assertEqual(self.faults(header_names.check, src__mesh__edge_collapse_dot_h=text, src__base__error_dot_h="class Error;",
                                     src__geometry__model_dot_h="class Model;", src__mesh__mesh_dot_h="struct TriangleMesh {};"),
                         ["src/mesh/edge_collapse.h: declares no name like its own"])

    def test_good_tree_passes(self):
        for check in structure.CHECKS:
            self.assertEqual(self.faults(check), [], check.__name__)

    def test_upward_include(self):
        found = self.faults(
            structure.check_includes,
            src__mesh__io_dot_h=LICENCE + '#include "triangulate/refine.cpp"\n',
        )
        self.assertEqual(len(found), 1)
        self.assertIn("src/mesh/io.h:2: mesh may not include triangulate/refine.cpp", found[0])

    def test_sideways_include(self):
        text = LICENCE + '#include "geometry/model.h"\n'
        self.assertEqual(len(self.faults(structure.check_includes, src__mesh__io_dot_h=text)), 1)

    def test_upward_arrow_in_cmake(self):
        wrong = CMAKE.replace("mq_module(mesh mq_base)", "mq_module(mesh mq_triangulate)")
        found = self.faults(structure.check_arrows, CMakeLists_dot_txt=wrong)
        self.assertIn("CMakeLists.txt: mq_mesh may not use mq_triangulate", found)

    def test_namespace_of_another_module(self):
        code = LICENCE + "namespace mq::geometry {\nint f();\n}  // namespace mq::geometry\n"
        self.assertEqual(self.faults(structure.check_namespaces, src__mesh__mesh_dot_h=code),
                         ["src/mesh/mesh.h:2: code of mesh is in mq::mesh, not in mq::geometry"])
        self.assertEqual(self.faults(structure.check_namespaces, src__geometry__occt__shape_dot_h=code), [])
        declared = LICENCE + "namespace mq::geometry {\nclass Model;\n}  // namespace mq::geometry\n"
        self.assertEqual(self.faults(structure.check_namespaces, src__triangulate__mesh_dot_h=declared), [])

    def test_foreign_headers(self):
        for header in ("BRep_Tool.hxx", "gp_Pnt.hxx", "pybind11/pybind11.h", "Inventor/SbVec3f.h"):
            text = LICENCE + f"#include <{header}>\n"
            found = self.faults(structure.check_includes, src__triangulate__size_dot_h=text)
            self.assertEqual(len(found), 1, header)

    def test_headers_of_systems(self):
        for header in ("unistd.h", "sys/mman.h", "windows.h"):
            text = LICENCE + f"#include <{header}>\n"
            self.assertEqual(len(self.faults(structure.check_includes, src__base__clock_dot_h=text)), 1, header)
            self.assertEqual(self.faults(structure.check_includes, src__base__system__clock_dot_cpp=text), [], header)

    def test_freecad_outside_its_place(self):
        text = f"# {structure.SPDX}\nimport FreeCAD\n"
        self.assertEqual(len(self.faults(structure.check_python_imports, bin__x_dot_py=text)), 1)
        self.assertEqual(self.faults(structure.check_python_imports, Mod__x_dot_py=text), [])

    def test_texts(self):
        cases = {
            "licence": "int x;\n",
            "length": LICENCE + "int x;\n" * structure.MAX_FILE,
            "unfinished": LICENCE + "// TO" + "DO later\n",
            "catch": LICENCE + "void f() { try { } catch (...) { } }\n",
            "print": LICENCE + "void f() { std::cout << 1; }\n",
        }
        for name, text in cases.items():
            found = self.faults(structure.check_texts, src__base__x_dot_cpp=text)
            self.assertEqual(len(found), 1, name)
        handed_on = LICENCE + "void f() { try { } catch (...) { throw; } }\n"
        self.assertEqual(self.faults(structure.check_texts, src__base__x_dot_cpp=handed_on), [])
        quoted = LICENCE + '// std::cout\nconst char* s = "std::cout";\n'
        self.assertEqual(self.faults(structure.check_texts, src__base__x_dot_cpp=quoted), [])

    def test_long_functions(self):
        body = "    x += 1;\n" * structure.MAX_FUNCTION
        long_cpp = LICENCE + "namespace mq {\nint f(int x) {\n" + body + "}\n}\n"
        long_py = f"# {structure.SPDX}\ndef f(x):\n" + body.replace(";", "")
        check = structure.check_functions
        self.assertEqual(len(self.faults(check, src__base__x_dot_cpp=long_cpp)), 1)
        self.assertEqual(len(self.faults(check, Mod__x_dot_py=long_py)), 1)


class Stages(unittest.TestCase):
    """The checks of folders find each kind of fault on a small tree."""

    def faults(self, check, *files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files:
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(LICENCE + text, encoding="utf-8")
            return check(Path(folder))

    def test_a_folder_that_is_no_stage(self):
        found = self.faults(stages.check_folders, ("src/mesh/heap/x.h", ""))
        self.assertEqual(found, ["src/mesh/heap is no stage of tests/tools/stages.py"])

    def test_a_folder_with_too_many_files(self):
        files = [(f"src/mesh/pair{k}.h", "") for k in range(stages.MAX_FILES + 1)]
        self.assertEqual(len(self.faults(stages.check_folders, *files)), 1)

    def test_an_include_of_a_higher_stage(self):
        low, high = ("src/mesh/x.h", '#include "mesh/io/y.h"\n'), ("src/mesh/io/y.h", "")
        found = self.faults(stages.check_stage_includes, low, high)
        self.assertEqual(found, ["src/mesh/x.h:2: mesh may not include mesh/io/y.h"])
        low, high = ("src/mesh/x.h", ""), ("src/mesh/io/y.h", '#include "mesh/x.h"\n')
        self.assertEqual(self.faults(stages.check_stage_includes, low, high), [])

    def test_a_test_in_another_folder(self):
        found = self.faults(stages.check_tests_mirror, ("src/mesh/io/y.h", ""), ("tests/cpp/mesh/y_test.cpp", ""))
        self.assertEqual(found, ["tests/cpp/mesh/y_test.cpp belongs to tests/cpp/mesh/io"])

    def test_too_few_tests(self):
        pairs = [(f"src/mesh/pair{k}{end}", "") for k in range(3) for end in (".h", ".cpp")]
        self.assertEqual(len(self.faults(stages.check_tested, *pairs)), 1)
        self.assertEqual(self.faults(stages.check_tested, *pairs, ("tests/cpp/mesh/pair0_test.cpp", ""),
                                     ("tests/cpp/mesh/pair1_test.cpp", "")), [])


class CppFunctions(unittest.TestCase):
    """The brace counter tells functions from classes, tables and initialisers."""

    CASES = {
        "namespace a {\nstruct B {\n int c{1};\n};\n}\n": [],
        "class A {\n public:\n  A() : a_(1) {\n  }\n int a_;\n};\n": [("A", 2)],
        "A::A(int b) : a_{b}, c_{1} {\n if (b) {\n }\n}\n": [("A::A", 4)],
        "const int kT[] = {\n1,\n2};\nint f() {\n}\n": [("f", 2)],
        "std::vector<P> v = {f(1), {2}};\n": [],
        "int g(int x)\n{\n auto l = [&] {\n };\n if (x) { }\n}\n": [("g", 6)],
        "template <class T>\nint h(T t) {\n}\n": [("h", 3)],
        "char c = '{'; int d = 1'000; // {\nint f() {}\n": [("f", 1)],
        "struct P f(int a) {\n}\n": [("f", 2)],
    }

    def test_kinds(self):
        for text, expected in self.CASES.items():
            found = [(name, length) for name, _, length in structure.cpp_functions(text)]
            self.assertEqual(found, expected, text)


if __name__ == "__main__":
    unittest.main()
