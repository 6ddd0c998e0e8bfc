// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMTRelease.h
 * @brief gives back a container's memory
 *
 * Assigning `{}` to a std::vector only empties it: the assignment from an initializer list is preferred, which keeps
 * the capacity.
 */
#ifndef vtkMTRelease_h
#define vtkMTRelease_h

template <class Container>
void vtkMTRelease(Container& container)
{
  Container().swap(container);
}

#endif
