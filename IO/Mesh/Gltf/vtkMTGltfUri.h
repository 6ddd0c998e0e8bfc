// SPDX-License-Identifier: BSD-3-Clause
// Uris of glTF files: names of files, percent-encoded (RFC 3986), and data in the uri itself (RFC 2397). Not installed.
#ifndef vtkMTGltfUri_h
#define vtkMTGltfUri_h

#include <string>
#include <vector>

namespace vtkMTGltfUri
{
/// %20 and so on become what they stand for; what is no such code stays.
std::string FromPercent(const std::string& uri);

/// Whether the uri begins with "data:".
bool HasData(const std::string& uri);

/// The data of such a uri, in base64 or percent-encoded. False where they are damaged.
bool DecodeData(const std::string& uri, std::vector<unsigned char>& bytes);
}

#endif
