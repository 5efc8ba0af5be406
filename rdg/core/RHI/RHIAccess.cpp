// Names of access states. Source: engine RHI.cpp.
#include "RHIAccess.h"

#include <bit>

FString GetRHIAccessName(ERHIAccess Access)
{
	static const TCHAR* const Names[] = {TEXT("CPURead"), TEXT("Present"), TEXT("IndirectArgs"),
		TEXT("VertexOrIndexBuffer"), TEXT("SRVCompute"), TEXT("SRVGraphics"), TEXT("CopySrc"), TEXT("ResolveSrc"),
		TEXT("DSVRead"), TEXT("UAVCompute"), TEXT("UAVGraphics"), TEXT("RTV"), TEXT("CopyDest"), TEXT("ResolveDst"),
		TEXT("DSVWrite"), TEXT("BVHRead"), TEXT("BVHWrite"), TEXT("Discard"), TEXT("ShadingRateSource")};
	static_assert(std::size(Names) == std::bit_width(uint32(ERHIAccess::Last)));

	FString Name;
	for (size_t Bit = 0; Bit < std::size(Names); ++Bit)
	{
		if (uint32(Access) & (1u << Bit))
		{
			Name += Name.IsEmpty() ? TEXT("") : TEXT("|");
			Name += Names[Bit];
		}
	}
	return Name.IsEmpty() ? FString(TEXT("Unknown")) : Name;
}
