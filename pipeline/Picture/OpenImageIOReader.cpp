// Finds the module beside this library.
#include "Picture/OpenImageIOReader.h"

#include <dlfcn.h>
#include <filesystem>
#include <stdexcept>

namespace Drydock
{

namespace
{

FMakeOpenImageIOReader LoadModule()
{
	Dl_info Own = {};
	dladdr(reinterpret_cast<const void*>(&LoadModule), &Own);
	const std::filesystem::path File = std::filesystem::path(Own.dli_fname).parent_path() / "libdrydock_openimageio.so";
	void* const Module = dlopen(File.c_str(), RTLD_NOW | RTLD_LOCAL);
	void* const Function = Module != nullptr ? dlsym(Module, MakeOpenImageIOReaderName) : nullptr;
	if (Function == nullptr)
	{
		throw std::runtime_error(std::string("the module that reads this format cannot be loaded: ") + dlerror());
	}
	return reinterpret_cast<FMakeOpenImageIOReader>(Function);
}

} // namespace

std::unique_ptr<IImageReader> MakeOpenImageIOReader(
	const std::string& Path, FImageBytesPointer Bytes, const std::string& Format)
{
	static const FMakeOpenImageIOReader Make = LoadModule();
	std::string Fault;
	std::unique_ptr<IImageReader> Reader(Make(Path.c_str(), Bytes, Format.c_str(), Fault));
	if (Reader == nullptr)
	{
		throw std::runtime_error(Fault);
	}
	return Reader;
}

} // namespace Drydock
