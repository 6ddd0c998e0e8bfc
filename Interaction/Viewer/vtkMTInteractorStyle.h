// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInteractorStyle
 * @brief keys for looking at models: all that a mouse can do, figures, colours, screenshots, camera paths
 *
 * A trackball style whose keys act on all vtkMultiTriangulationMapper of a renderer, and on whatever else it shows
 * where that makes sense. Over the picture it writes the figures of the frame (triangles, patches, error, times,
 * memory), a message and, on a key, all keys; where models are coloured by an array it draws a scalar bar. GetKeys has
 * the keys as text.
 *
 * The camera can be recorded while it moves, or view by view, into a vtkMTCameraPath, which is written into a file and
 * played. Screenshots and paths are written into new files and never replace one.
 *
 * No key needs an interactor: PressKey does what a key does, also off screen.
 *
 * @code
 * vtkNew<vtkMTInteractorStyle> style;
 * style->SetRenderer(renderer); // which is in a window already
 * interactor->SetInteractorStyle(style);
 * @endcode
 *
 * @sa vtkMTCameraPath vtkMultiTriangulationMapper
 */
#ifndef vtkMTInteractorStyle_h
#define vtkMTInteractorStyle_h

#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkMTInteractionModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string>

class vtkMTCameraPath;

class VTKMTINTERACTION_EXPORT vtkMTInteractorStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static vtkMTInteractorStyle* New();
  vtkTypeMacro(vtkMTInteractorStyle, vtkInteractorStyleTrackballCamera);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// What the keys act on and the figures are of. It must be in a window, of whose layers the second one becomes that
  /// of the figures. Default: none; then there are VTK's own keys only.
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /// Whether the figures of the frame are shown (default on), the list of keys (default off), and a scalar bar where
  /// models are coloured by an array (default on).
  void SetShowFigures(bool on);
  bool GetShowFigures();
  vtkBooleanMacro(ShowFigures, bool);
  vtkSetMacro(ShowKeys, bool);
  vtkGetMacro(ShowKeys, bool);
  vtkBooleanMacro(ShowKeys, bool);
  void SetShowScalarBar(bool on);
  bool GetShowScalarBar();
  vtkBooleanMacro(ShowScalarBar, bool);
  ///@}

  ///@{
  /// A text under the figures, of one or more lines: what the program is doing. No key changes it. Default: empty.
  vtkSetStdStringFromCharMacro(Status);
  vtkGetCharFromStdStringMacro(Status);
  ///@}

  ///@{
  /// A text under the status, of one or more lines: what the last key did. Default: empty.
  vtkSetStdStringFromCharMacro(Message);
  vtkGetCharFromStdStringMacro(Message);
  ///@}

  ///@{
  /**
   * What all models are coloured by: "level", "patch", "error" (in pixels), the name of an array of points or cells, or
   * "", the default: colours and textures of the data. An array spans one range for all models; models without it have
   * the colour of their property. False, with nothing changed, where no model has such an array. ColorsChanged is to be
   * called when models have come.
   */
  bool SetColorBy(const char* name);
  const char* GetColorBy();
  void ColorsChanged();
  ///@}

  ///@{
  /// The arrays that a key goes through: of points, then of cells, those for picking left out.
  int GetNumberOfColorArrays();
  /// "" where there is none of that index.
  std::string GetColorArrayName(int index);
  ///@}

  ///@{
  /// What the names of screenshots begin with, a folder included: PREFIX-0001.png and so on. Default "bmt"; an empty or
  /// null one is ignored.
  void SetScreenshotPrefix(const char* prefix);
  vtkGetCharFromStdStringMacro(ScreenshotPrefix);
  ///@}

  /// Writes what the window shows into a new file (PNG), and gives its name; "" on failure, with the reason as message.
  std::string TakeScreenshot();

  ///@{
  /// The path that is recorded and played; never null. Null is ignored.
  void SetCameraPath(vtkMTCameraPath* path);
  vtkMTCameraPath* GetCameraPath();
  ///@}

  ///@{
  /// What the names of the files begin with that recorded paths are written to, a folder included: PREFIX-0001.csv and
  /// so on. Default "bmt-path"; an empty or null one is ignored.
  void SetPathPrefix(const char* prefix);
  vtkGetCharFromStdStringMacro(PathPrefix);
  ///@}

  ///@{
  /**
   * Records the camera, with every frame in which it has moved but 60 times a second at most, into a new path. Stopping
   * writes it into a file and gives its name; "" where nothing was recorded or it could not be written, with the reason
   * as message. A recording ends a replay.
   */
  void StartRecording();
  std::string StopRecording();
  bool GetRecording() const;
  ///@}

  /// Writes the path into a new file, and gives its name; "" where it is empty or on failure, with the reason as
  /// message.
  std::string WritePath();

  ///@{
  /**
   * Plays the path once, by the clock: what a slow frame misses is left out. It goes on with the interactor's timers,
   * of which each draws a frame. Without views, or while recording, nothing is played.
   */
  void StartPlaying();
  void StopPlaying();
  bool GetPlaying() const;
  ///@}

  /**
   * Draws every frame of the path, the last one included, at FrameRate, however long that takes; where prefix is no
   * empty text, each becomes a picture in a new file, as screenshots do. An AbortCheckEvent after each frame can end it
   * (StopPlaying). Gives the number of frames; -1 where a picture could not be written, with the reason as message.
   */
  int RenderPath(const char* prefix = "");

  ///@{
  /// Frames per second of a replay: those that the timer asks for, and those of RenderPath. Default 30; clamped to [1,
  /// 240]; NaN is refused with an error event.
  void SetFrameRate(double framesPerSecond);
  vtkGetMacro(FrameRate, double);
  ///@}

  /**
   * What a key does, by its character or, for those without one, by X's name of it: "Left", "Prior" (page up), "F1",
   * with "Shift+" or "Control+" before it. Renders. False where the style has no such key.
   */
  bool PressKey(const char* key);

  /// All keys and what they do, one line each.
  static std::string GetKeys();

  /// What is written over the picture in the last frame.
  std::string GetOverlayText();

  void OnKeyPress() override;
  void OnChar() override;
  void OnTimer() override;

protected:
  vtkMTInteractorStyle();
  ~vtkMTInteractorStyle() override;

private:
  vtkMTInteractorStyle(const vtkMTInteractorStyle&) = delete;
  void operator=(const vtkMTInteractorStyle&) = delete;

  struct Internals;
  struct Keys;
  std::string GetTextBelowFigures() const;
  void OnFrame();
  void Play();
  void RenderAll();

  bool ShowKeys = false;
  std::string Status;
  std::string Message;
  std::string ScreenshotPrefix = "bmt";
  std::string PathPrefix = "bmt-path";
  double FrameRate = 30.0;
  std::unique_ptr<Internals> Implementation;
};

#endif
