// SPDX-License-Identifier: BSD-3-Clause
// The module _interpreter: VTK 9.1's wrappers hold the global interpreter lock while a method runs; this has the
// toolkit's filters release it while they work, and end their work when the user presses Ctrl-C.
//
// Meanwhile SIGINT is noted here instead of in Python, so that it ends the work and not an observer that happens to
// run: VTK leaves the process when an observer is interrupted. It is handed to Python when the work is over and no
// observer runs any more (newer pipelines report the end of what was ended), which then raises KeyboardInterrupt where
// the method was called. Handlers other than Python's own are left alone.
#include "vtkPython.h"

#include "Interpreter/vtkMTLongWork.h"

#include <csignal>

namespace
{
volatile std::sig_atomic_t Interrupted = 0;
thread_local bool HandlesInterrupts = false;
unsigned long MainThread = 0;

void NoteInterrupt(int /*signal*/)
{
  Interrupted = 1;
}

// What is to be put right when the work is over.
struct State
{
  PyThreadState* Thread = nullptr;
  PyFrameObject* Caller = nullptr; // of the method that works
  bool HandlesInterrupts = false;
  struct sigaction Before = {};
};

// Signals are the main thread's in Python.
bool HasPythonsHandler()
{
  if (PyThread_get_thread_ident() != MainThread)
  {
    return false;
  }
  PyObject* module = PyImport_ImportModule("signal");
  PyObject* present = module ? PyObject_CallMethod(module, "getsignal", "i", SIGINT) : nullptr;
  PyObject* usual = module ? PyObject_GetAttrString(module, "default_int_handler") : nullptr;
  const bool same = present && present == usual;
  Py_XDECREF(usual);
  Py_XDECREF(present);
  Py_XDECREF(module);
  PyErr_Clear();
  return same;
}

// Whether the Python code that runs was called while a frame waits: by an observer of what that frame has called.
bool RunsBelow(const PyFrameObject* frame)
{
  PyFrameObject* above = PyEval_GetFrame();
  Py_XINCREF(above);
  bool isBelow = false;
  while (above && !isBelow)
  {
    PyFrameObject* next = PyFrame_GetBack(above);
    Py_DECREF(above);
    above = next;
    isBelow = above == frame;
  }
  Py_XDECREF(above);
  return isBelow;
}

// Called by Python before it goes on with any code.
int HandOn(void* pointer)
{
  auto* caller = static_cast<PyFrameObject*>(pointer);
  if (caller && RunsBelow(caller) && Py_AddPendingCall(&HandOn, caller) == 0)
  {
    return 0;
  }
  Py_XDECREF(caller);
  PyErr_SetInterrupt();
  return 0;
}

void* Release()
{
  if (!Py_IsInitialized() || !PyGILState_Check())
  {
    return nullptr;
  }
  auto* state = new State;
  if (HasPythonsHandler())
  {
    struct sigaction noting = {};
    noting.sa_handler = &NoteInterrupt;
    sigemptyset(&noting.sa_mask);
    Interrupted = 0;
    state->HandlesInterrupts = sigaction(SIGINT, &noting, &state->Before) == 0;
    HandlesInterrupts = state->HandlesInterrupts;
    state->Caller = PyEval_GetFrame();
    Py_XINCREF(state->Caller);
  }
  state->Thread = PyEval_SaveThread();
  return state;
}

void Acquire(void* pointer)
{
  auto* state = static_cast<State*>(pointer);
  PyEval_RestoreThread(state->Thread);
  if (state->HandlesInterrupts)
  {
    HandlesInterrupts = false;
    sigaction(SIGINT, &state->Before, nullptr);
    if (Interrupted && Py_AddPendingCall(&HandOn, state->Caller) == 0)
    {
      state->Caller = nullptr; // it is HandOn's
    }
    else if (Interrupted)
    {
      PyErr_SetInterrupt();
    }
  }
  Py_XDECREF(state->Caller);
  delete state;
}

bool IsInterrupted()
{
  return HandlesInterrupts && Interrupted;
}

PyObject* Install(PyObject* /*self*/, PyObject* mainThread)
{
  MainThread = PyLong_AsUnsignedLong(mainThread);
  if (PyErr_Occurred())
  {
    return nullptr;
  }
  vtkMTLongWork::SetInterpreter({ &Release, &Acquire, &IsInterrupted });
  Py_RETURN_NONE;
}

PyMethodDef Methods[] = { { "install", &Install, METH_O,
                            "Has the toolkit's filters release the lock; the ident of the main thread." },
  { nullptr, nullptr, 0, nullptr } };

PyModuleDef Module = { PyModuleDef_HEAD_INIT, "_interpreter", nullptr, -1, Methods, nullptr, nullptr, nullptr,
  nullptr };
}

PyMODINIT_FUNC PyInit__interpreter()
{
  return PyModule_Create(&Module);
}
