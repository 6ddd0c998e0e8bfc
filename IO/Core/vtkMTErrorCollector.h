// SPDX-License-Identifier: BSD-3-Clause
// Collects the error events of VTK objects as one message. Not installed.
#ifndef vtkMTErrorCollector_h
#define vtkMTErrorCollector_h

#include "vtkMTIOCoreModule.h" // For export macro
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkCallbackCommand;
class vtkCommand;
class vtkObject;
class vtkOutputWindow;

class VTKMTIOCORE_EXPORT vtkMTErrorCollector
{
public:
  vtkMTErrorCollector();
  /// Stops observing.
  ~vtkMTErrorCollector();

  /// Observes the algorithm and its executive.
  void Observe(vtkAlgorithm* algorithm);
  void Observe(vtkObject* object);
  /// What VTK says without naming an object that could be observed: some readers report damage by warnings of no one.
  /// While this lives it is collected instead of being displayed; whatever other threads say in the meantime, too.
  void ObserveOutputWindow(bool warningsToo);
  /// Has a reader of VTK's XML files not say that it lacks a module (vtkExodusIIReader's, say) which defines a key of
  /// an array's information: neither its values nor its name depend on that. Its other warnings are displayed as
  /// before.
  static void IgnoreUnknownKeys(vtkAlgorithm* reader);
  /// For objects that take an error observer instead of being observed.
  vtkCommand* GetCommand();

  bool HasErrors() const { return !this->Messages.empty(); }
  /// The first few messages, without VTK's file names, line numbers and addresses.
  std::string GetMessage() const;

private:
  vtkMTErrorCollector(const vtkMTErrorCollector&) = delete;
  void operator=(const vtkMTErrorCollector&) = delete;
  static void Collect(vtkObject* caller, unsigned long event, void* self, void* text);

  std::vector<std::string> Messages;
  vtkNew<vtkCallbackCommand> Command;
  vtkSmartPointer<vtkOutputWindow>
    Displaced; // the output window that displays messages otherwise; null: it is in place
  std::vector<std::pair<vtkSmartPointer<vtkObject>, unsigned long>> Observed;
};

#endif
