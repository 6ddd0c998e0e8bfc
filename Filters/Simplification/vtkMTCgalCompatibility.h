// SPDX-License-Identifier: BSD-3-Clause
// What differs between the versions of CGAL that the toolkit builds against: 5.5 (Debian 12) and 6.0 (Debian 13).
#ifndef vtkMTCgalCompatibility_h
#define vtkMTCgalCompatibility_h

#include <CGAL/config.h>

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <optional>
#else
#include <boost/optional.hpp>
#endif

/// Members of CGAL's algorithms are private: they are specialised for the versions that they were written for only,
/// whose internal/Edge_collapse.h is the same but for the class of optional values.
#define vtkMT_CGAL_IS_KNOWN                                                                                            \
  ((CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(5, 5, 0) && CGAL_VERSION_NR < CGAL_VERSION_NUMBER(5, 6, 0)) ||              \
    (CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0) && CGAL_VERSION_NR < CGAL_VERSION_NUMBER(6, 1, 0)))

namespace vtkMTCollapse
{
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
template <class T>
using Optional = std::optional<T>;
#else
template <class T>
using Optional = boost::optional<T>;
#endif
}

#endif
