#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The reader of .ot files against OctoMap's own writer.

    test_octree_file.py PROGRAM_THAT_WRITES_TREES
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from octree_file import OctreeFileError, read_octree  # noqa: E402

WRITER = sys.argv.pop()


class OctreeFileTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        subprocess.run([WRITER, str(cls.folder)], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def expect_same(self, name, voxel_size):
        expected = np.loadtxt(self.folder / f"{name}.txt", ndmin=2)
        centers, sizes, probabilities, resolution = read_octree(self.folder / f"{name}.ot")
        self.assertAlmostEqual(resolution, voxel_size)
        read = np.column_stack([centers, sizes, probabilities])
        self.assertEqual(read.shape, expected.shape)
        # Both list leaves depth first. OctoMap computes in float.
        np.testing.assert_allclose(read, expected, rtol=1e-5, atol=1e-5)
        return read

    def test_reads_every_leaf_of_a_sparse_tree(self):
        self.assertGreater(len(self.expect_same("scattered", 0.03)), 400)

    def test_reads_pruned_leaves_with_their_size(self):
        sizes = self.expect_same("pruned", 0.05)[:, 3]
        self.assertGreater(sizes.max(), 0.3)
        self.assertAlmostEqual(np.sum(sizes**3), (16 * 0.05) ** 3)

    def test_reads_an_empty_tree(self):
        centers, _, probabilities, resolution = read_octree(self.folder / "empty.ot")
        self.assertEqual((centers.shape, len(probabilities), resolution), ((0, 3), 0, 0.1))

    def test_names_a_damaged_file(self):
        whole = (self.folder / "scattered.ot").read_bytes()
        for name, content in (("cut", whole[:-7]), ("long", whole + b"12345"), ("other", b"PLY\n")):
            damaged = self.folder / f"{name}.ot"
            damaged.write_bytes(content)
            with self.assertRaisesRegex(OctreeFileError, name):
                read_octree(damaged)


if __name__ == "__main__":
    unittest.main()
