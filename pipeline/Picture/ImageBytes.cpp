// Remembers the bytes that stand for a file, one for each thread.
#include "Picture/ImageBytes.h"

namespace Drydock
{

namespace
{

thread_local const FImageBytes* GCurrent = nullptr;

} // namespace

FImageBytes::FImageBytes(const std::string& InName, const std::string& InBytes)
	: Name(InName)
	, Bytes(InBytes)
{
	GCurrent = this;
}

FImageBytes::~FImageBytes()
{
	GCurrent = nullptr;
}

const std::string* FImageBytes::Find(const std::string& Name)
{
	return GCurrent != nullptr && GCurrent->Name == Name ? &GCurrent->Bytes : nullptr;
}

} // namespace Drydock
