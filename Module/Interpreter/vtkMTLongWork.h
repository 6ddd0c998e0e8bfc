// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLongWork
 * @brief lets an interpreter's other threads run while a filter works, and its user interrupt it
 *
 * A filter that works for long has one on its stack while it does. An interpreter that called the filter (the Python
 * package installs itself by SetInterpreter) gives its lock away until that is gone. Events of VTK's objects may be
 * invoked meanwhile: VTK's Python observers take the lock themselves. Whoever asks whether a filter was aborted
 * (vtkMTIsAborted) hears of an interrupt too.
 *
 * Without an interpreter, or in a thread that does not hold its lock, it does nothing. They may be nested.
 */
#ifndef vtkMTLongWork_h
#define vtkMTLongWork_h

#include "vtkMTCoreModule.h" // For export macro

class VTKMTCORE_EXPORT vtkMTLongWork
{
public:
  struct Interpreter
  {
    /// Gives this thread's lock away; null if it has none.
    void* (*Release)() = nullptr;
    /// Takes it again; state: what Release gave.
    void (*Acquire)(void* state) = nullptr;
    /// Whether the user wants this thread's work, whose lock was released, to end.
    bool (*IsInterrupted)() = nullptr;
  };

  /// To be called once, before there is work. All three functions are needed.
  static void SetInterpreter(const Interpreter& interpreter);

  vtkMTLongWork();
  ~vtkMTLongWork();
  vtkMTLongWork(const vtkMTLongWork&) = delete;
  vtkMTLongWork& operator=(const vtkMTLongWork&) = delete;

  /// Whether the work of this thread is to end.
  static bool IsInterrupted();

private:
  void* State = nullptr;
};

#endif
