// Makes OpenImageIO's reader without the module that a program loads: it is linked with the fuzzers.
#include "Picture/OpenImageIOReader.h"

#include <stdexcept>

extern "C" Drydock::IImageReader* DrydockMakeOpenImageIOReader(
	const char* Path, Drydock::FImageBytesPointer Bytes, const char* Format, std::string& OutFault);

namespace Drydock
{

std::unique_ptr<IImageReader> MakeOpenImageIOReader(
	const std::string& Path, FImageBytesPointer Bytes, const std::string& Format)
{
	std::string Fault;
	std::unique_ptr<IImageReader> Reader(DrydockMakeOpenImageIOReader(Path.c_str(), Bytes, Format.c_str(), Fault));
	if (Reader == nullptr)
	{
		throw std::runtime_error(Fault);
	}
	return Reader;
}

} // namespace Drydock
