// SPDX-License-Identifier: BSD-3-Clause
#ifdef MT_HAS_GDAL

#include "vtkMTGdalLibrary.h"

#include <vtksys/DynamicLoader.hxx>

//------------------------------------------------------------------------------
bool vtkMTGdalLibrary::Load(const std::string& name, std::string& error)
{
  using Loader = vtksys::DynamicLoader;
  const Loader::LibraryHandle library = Loader::OpenLibrary(name);
  if (!library)
  {
    const char* reason = Loader::LastError();
    error = "is read through GDAL, which cannot be loaded (" + (reason ? std::string(reason) : name) +
      "); install it, or make an .hgt of the file elsewhere ('gdal_translate -of SRTMHGT')";
    return false;
  }
  std::string missing;
  const auto find = [&](const char* function, auto& pointer)
  {
    pointer = reinterpret_cast<std::decay_t<decltype(pointer)>>(Loader::GetSymbolAddress(library, function));
    missing = pointer ? missing : function;
  };
#define MT_GDAL_FIND(function) find(#function, this->function);
  MT_GDAL_FUNCTIONS(MT_GDAL_FIND)
#undef MT_GDAL_FIND
  if (!missing.empty())
  {
    error = "is read through GDAL, and " + name + " has no function " + missing;
  }
  return missing.empty();
}

//------------------------------------------------------------------------------
const vtkMTGdalLibrary* vtkMTGdalLibrary::Get(std::string& error)
{
  struct Loaded
  {
    vtkMTGdalLibrary Library;
    std::string Error;
    bool IsThere;

    Loaded()
      : IsThere(this->Library.Load(MT_GDAL_NAME, this->Error))
    {
      if (this->IsThere)
      {
        this->Library.GDALRegister_GTiff();
      }
    }
  };
  static const Loaded loaded; // stays loaded: GDAL's threads and tables end with the process
  error = loaded.IsThere ? error : loaded.Error;
  return loaded.IsThere ? &loaded.Library : nullptr;
}

#endif
