// SPDX-License-Identifier: BSD-3-Clause
// Bytes that zlib or gzip packed. Not installed.
#ifndef vtkMTInflate_h
#define vtkMTInflate_h

#include <cstddef>
#include <cstdint>
#include <string>

class vtkMTByteSource;

/// Of what is packed from offset on, in one or several members, leaves out skip bytes and takes the next count.
/// toEnd: goes on to the end of the member, where its checksum is compared; for what should be all of it. False with
/// the reason in error when there are not so many bytes, or they are damaged.
bool vtkMTInflate(const vtkMTByteSource& source, std::uint64_t offset, std::uint64_t skip, std::size_t count,
  void* destination, bool toEnd, std::string& error);

#endif
