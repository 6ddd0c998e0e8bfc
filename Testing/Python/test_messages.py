#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK says while a file is read: nothing about keys of modules that are not there; what is wrong, once."""
import os
import subprocess
import sys
import tempfile
import unittest

MESH = """<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt32">
  <PolyData>
    <Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="4">
      <PointData>
        <DataArray type="Float32" Name="height" format="ascii">
          0 0 0 1
          <InformationKey name="GLOBAL_TEMPORAL_VARIABLE" location="vtkExodusIIReader">1</InformationKey>
        </DataArray>
      </PointData>
      <CellData></CellData>
      <Points>
        <DataArray type="Float32" Name="Points" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray>
      </Points>
      <Polys>
        <DataArray type="Int64" Name="connectivity" format="ascii">0 2 1 0 1 3 1 2 3 2 0 3</DataArray>
        <DataArray type="Int64" Name="offsets" format="ascii">3 6 9 12</DataArray>
      </Polys>
    </Piece>
  </PolyData>
</VTKFile>
"""

BUILD = """
import sys
from multitriangulation import vtkMultiTriangulationFileBuilder
builder = vtkMultiTriangulationFileBuilder()
builder.SetFileName(sys.argv[1])
builder.SetOutputFileName(sys.argv[2])
builder.SetMemoryLimit(int(sys.argv[3]))
sys.exit(0 if builder.Write() else 1)
"""

VERIFY = """
import sys
from multitriangulation import vtkMultiTriangulationReader, vtkMultiTriangulationVerifier
reader = vtkMultiTriangulationReader()
reader.SetFileName(sys.argv[2])
verifier = vtkMultiTriangulationVerifier()
verifier.SetInputConnection(reader.GetOutputPort())
verifier.AddInputFileName(sys.argv[1])
verifier.Update()
sys.exit(0 if verifier.GetErrorCode() == 0 and verifier.GetInputChecked() else 1)
"""


class Messages(unittest.TestCase):
    def run_script(self, script, *arguments):
        done = subprocess.run(
            [sys.executable, "-c", script, *map(str, arguments)], capture_output=True, text=True, check=False)
        print(done.stderr, end="")
        return done.returncode, done.stderr

    def test_keys_of_absent_modules_are_not_mentioned(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh, model = os.path.join(folder, "mesh.vtp"), os.path.join(folder, "mesh.bmt")
            with open(mesh, "w", encoding="ascii") as file:
                file.write(MESH)
            for limit in (0, 1 << 28):  # read at once, and streamed
                self.assertEqual(self.run_script(BUILD, mesh, model, limit), (0, ""))
            self.assertEqual(self.run_script(VERIFY, mesh, model), (0, ""))

    def test_what_is_wrong_is_said_once(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh, model = os.path.join(folder, "mesh.vtp"), os.path.join(folder, "mesh.bmt")
            with open(mesh, "w", encoding="ascii") as file:
                file.write(MESH.replace("0 2 1 0 1 3 1 2 3 2 0 3", "0 2 1 0 1"))
            code, messages = self.run_script(BUILD, mesh, model, 0)
            self.assertEqual(code, 1)
            self.assertEqual(messages.count("mesh.vtp"), 1)
            self.assertFalse(os.path.exists(model))


if __name__ == "__main__":
    unittest.main()
