#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""While a filter works, Python's other threads run, and Ctrl-C ends the work with KeyboardInterrupt."""
import os
import signal
import sys
import tempfile
import threading
import time
import unittest

import multitriangulation as mt
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYWriter


def make_sphere(resolution):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    return source


def interrupt_at(algorithm, fraction):
    """Has the first progress event from the fraction on send what Ctrl-C sends. Returns when that was, and all events."""
    sent, seen = [], []

    def on_progress(caller, event):
        seen.append(caller.GetProgress())
        if not sent and caller.GetProgress() >= fraction:
            sent.append(caller.GetProgress())
            os.kill(os.getpid(), signal.SIGINT)

    return sent, seen, algorithm.AddObserver("ProgressEvent", on_progress)


class OtherThreads(unittest.TestCase):
    def test_run_while_a_model_is_built(self):
        """No thread is made to give the lock away here by the interpreter, so another one runs only if that is released."""
        interval = sys.getswitchinterval()
        sys.setswitchinterval(1000.0)
        count, end = [0], threading.Event()

        def run():
            while not end.wait(0.001):
                count[0] += 1

        thread = threading.Thread(target=run)
        thread.start()
        builder = mt.vtkMultiTriangulationBuilder()
        builder.SetInputData(make_sphere(60).GetOutput())
        try:
            for attempt in range(50):
                builder.Modified()
                before = count[0]
                builder.Update()
                gained = count[0] - before
                if gained:
                    break
        finally:
            sys.setswitchinterval(interval)
            end.set()
            thread.join()
        print("build", attempt + 1, "let another thread run", gained, "times")
        self.assertGreater(gained, 0)


class Interrupt(unittest.TestCase):
    def expect_interrupt(self, algorithm, run):
        sent, seen, tag = interrupt_at(algorithm, 0.1)
        with self.assertRaises(KeyboardInterrupt):
            run()
            time.sleep(0)
        algorithm.RemoveObserver(tag)
        self.assertEqual(len(sent), 1)
        stopped = max(fraction for fraction in seen if fraction < 1.0)  # newer pipelines report the end as well
        print(algorithm.GetClassName(), "interrupted at", sent[0], "stopped at", stopped)
        self.assertLess(stopped, 0.9)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_a_build_of_a_file_leaves_what_was_there(self):
        with tempfile.TemporaryDirectory() as folder:
            writer = vtkPLYWriter()
            writer.SetInputData(make_sphere(150).GetOutput())
            writer.SetFileName(folder + "/sphere.ply")
            writer.Write()
            builder = mt.vtkMultiTriangulationFileBuilder()
            builder.SetFileName(folder + "/sphere.ply")
            builder.SetOutputFileName(folder + "/sphere.bmt")
            builder.SetPatchTriangles(200)
            self.expect_interrupt(builder, builder.Write)
            self.assertEqual(sorted(os.listdir(folder)), ["sphere.ply"])
            self.assertEqual(builder.GetErrorCode(), builder.AbortError)
            self.assertEqual(builder.Write(), 1, builder.GetErrorMessage())
            with open(folder + "/sphere.bmt", "rb") as file:
                whole = file.read()
            self.expect_interrupt(builder, builder.Write)
            with open(folder + "/sphere.bmt", "rb") as file:
                self.assertEqual(file.read(), whole)
            self.assertEqual(sorted(os.listdir(folder)), ["sphere.bmt", "sphere.ply"])

    def test_filters_of_a_pipeline_stop_and_can_go_on(self):
        builder = mt.vtkMultiTriangulationBuilder()
        builder.SetInputData(make_sphere(150).GetOutput())
        builder.SetPatchTriangles(200)
        self.expect_interrupt(builder, builder.Update)
        self.assertEqual(builder.GetOutput().GetNumberOfPatches(), 0)
        builder.Modified()
        builder.Update()
        self.assertGreater(builder.GetOutput().GetNumberOfPatches(), 10)

        cut = mt.vtkMultiTriangulationCutFilter()
        cut.SetTriangleLimit(40000)
        verifier = mt.vtkMultiTriangulationVerifier()
        for each in (cut, verifier):
            each.SetInputConnection(builder.GetOutputPort())
            self.expect_interrupt(each, each.Update)
            each.Modified()
            each.Update()
            self.assertEqual(each.GetErrorMessage(), "")

    def test_a_handler_of_the_user_is_called_and_decides(self):
        calls = []
        signal.signal(signal.SIGINT, lambda number, frame: calls.append(number))
        try:
            builder = mt.vtkMultiTriangulationBuilder()
            builder.SetInputData(make_sphere(60).GetOutput())
            sent, _, _ = interrupt_at(builder, 0.1)
            builder.Update()
        finally:
            signal.signal(signal.SIGINT, signal.default_int_handler)
        self.assertEqual((len(sent), calls), (1, [signal.SIGINT]))
        self.assertGreater(builder.GetOutput().GetNumberOfPatches(), 0)


if __name__ == "__main__":
    unittest.main()
