// Names of the views that the source pass makes of a buffer of bytes: a variable of its own in SPIR-V, the same memory.
#pragma once

#include <string>

namespace Drydock
{

/** Between the buffer's name and what the view holds: "Bytes__DrydockViewOfLongs". */
inline constexpr const char* GBufferViewMark = "__DrydockViewOf";

/** "Bytes": the memory that a variable names. */
inline std::string GetViewedBuffer(const std::string& Name)
{
	return Name.substr(0, Name.find(GBufferViewMark));
}

} // namespace Drydock
