// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFileSink
 * @brief a patch sink that makes a Multi-Triangulation file
 *
 * Patches come finest first and lie in the file coarsest first, after the DAG, which is known last. So WritePatch
 * appends each one, encoded, to a spool, and Finish copies them in arc order behind header and DAG into a file that is
 * published whole (vtkMTOutputFile). What stays in memory is a record for each section and patch, and the patch that is
 * written. The disk must have room for the model twice while Finish runs.
 *
 * The spool is a nameless file in the output's folder; or, when a store is given, of that store: then the sink can go
 * on in another process (Save and Restore) as far as the store can.
 *
 * The bytes depend on the patches and the graph alone.
 */
#ifndef vtkMTFileSink_h
#define vtkMTFileSink_h

#include "vtkMTIOModule.h" // For export macro
#include "vtkMTPatchSink.h"

#include <memory>
#include <string>

class vtkMTSpoolStore;

class VTKMTIO_EXPORT vtkMTFileSink : public vtkMTPatchSink
{
public:
  /// How geometry and arrays are made smaller. None of them loses anything but for normals that the builder made
  /// (vtkMTColumnCodec); patches are put into the order of storage (vtkMTPatchOrder) with all of them.
  enum CompressionType
  {
    None, ///< as in memory, with narrow integers
    Fast, ///< the default: packed, then LZ4
    Small ///< packed, then zstd: some percent smaller, slower to write and to read
  };

  /// The store, if any, must outlive the sink.
  explicit vtkMTFileSink(const std::string& path, CompressionType compression = Fast, vtkMTSpoolStore* store = nullptr);
  /// A model that was not finished is abandoned.
  ~vtkMTFileSink() override;

  bool Begin(const std::vector<vtkMTArrayInfo>& arrays) override;
  bool WritePatch(vtkMTPatch&& patch) override;
  std::unique_ptr<PreparedPatch> Prepare(vtkMTPatch&& patch, std::string& error) const override;
  bool WritePrepared(std::unique_ptr<PreparedPatch> patch) override;
  bool WriteBlob(std::vector<unsigned char>&& bytes) override;
  bool Finish(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc) override;
  void Abandon() override;
  bool Save(std::vector<unsigned char>& state) override;
  bool Restore(const std::vector<vtkMTArrayInfo>& arrays, const std::vector<unsigned char>& state) override;

  /// Bytes of the file that Finish has made.
  std::uint64_t GetFileSize() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
