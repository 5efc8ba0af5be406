// Holds the place of a call in the source.
#pragma once

#include "CoreTypes.h"

namespace Drydock
{

/** Replaces std::source_location, which some compilers that build plugins lack (clang before 16). It is one type for
 * all compilers, because it stands in signatures of the library. */
struct FSourceLocation
{
	const char* File = "";
	uint32 Line = 0;

	/** As a default argument: the place of the call. */
	static constexpr FSourceLocation Current(
		const char* InFile = __builtin_FILE(), uint32 InLine = static_cast<uint32>(__builtin_LINE()))
	{
		return {InFile, InLine};
	}
};

} // namespace Drydock
