// Lists the access states of resources, by what a pass does with a resource. Drydock needs no barriers; the states
// describe the graph. Source: engine RHIAccess.h (5.3 numbering).
#pragma once

#include "CoreMinimal.h"

enum class ERHIAccess : uint32
{
	Unknown = 0,
	CPURead = 1 << 0,
	Present = 1 << 1,
	IndirectArgs = 1 << 2,
	VertexOrIndexBuffer = 1 << 3,
	SRVCompute = 1 << 4,
	SRVGraphics = 1 << 5,
	CopySrc = 1 << 6,
	ResolveSrc = 1 << 7,
	DSVRead = 1 << 8,
	UAVCompute = 1 << 9,
	UAVGraphics = 1 << 10,
	RTV = 1 << 11,
	CopyDest = 1 << 12,
	ResolveDst = 1 << 13,
	DSVWrite = 1 << 14,
	BVHRead = 1 << 15,
	BVHWrite = 1 << 16,
	Discard = 1 << 17,
	ShadingRateSource = 1 << 18,
	Last = ShadingRateSource,
	None = Unknown,
	Mask = (Last << 1) - 1,

	SRVMask = SRVCompute | SRVGraphics,
	UAVMask = UAVCompute | UAVGraphics,
	ReadOnlyExclusiveMask = CPURead | Present | IndirectArgs | VertexOrIndexBuffer | SRVGraphics | SRVCompute |
							CopySrc | ResolveSrc | BVHRead | ShadingRateSource,
	ReadOnlyExclusiveComputeMask = CPURead | IndirectArgs | SRVCompute | CopySrc | BVHRead,
	ReadOnlyMask = ReadOnlyExclusiveMask | DSVRead | ShadingRateSource,
	ReadableMask = ReadOnlyMask | UAVMask,
	WriteOnlyExclusiveMask = RTV | CopyDest | ResolveDst,
	WriteOnlyMask = WriteOnlyExclusiveMask | DSVWrite,
	WritableMask = WriteOnlyMask | UAVMask | BVHWrite,
};
ENUM_CLASS_FLAGS(ERHIAccess)

inline bool IsReadOnlyExclusiveAccess(ERHIAccess Access)
{
	return EnumHasAnyFlags(Access, ERHIAccess::ReadOnlyExclusiveMask) &&
		   !EnumHasAnyFlags(Access, ~ERHIAccess::ReadOnlyExclusiveMask);
}

inline bool IsReadOnlyAccess(ERHIAccess Access)
{
	return EnumHasAnyFlags(Access, ERHIAccess::ReadOnlyMask) && !EnumHasAnyFlags(Access, ~ERHIAccess::ReadOnlyMask);
}

inline bool IsWriteOnlyAccess(ERHIAccess Access)
{
	return EnumHasAnyFlags(Access, ERHIAccess::WriteOnlyMask) && !EnumHasAnyFlags(Access, ~ERHIAccess::WriteOnlyMask);
}

inline bool IsWritableAccess(ERHIAccess Access)
{
	return EnumHasAnyFlags(Access, ERHIAccess::WritableMask);
}

inline bool IsReadableAccess(ERHIAccess Access)
{
	return EnumHasAnyFlags(Access, ERHIAccess::ReadableMask);
}

/** Not both read-only-exclusive and writable, nor write-only-exclusive and readable. */
inline bool IsValidAccess(ERHIAccess Access)
{
	const bool bReadAndWrite = EnumHasAnyFlags(Access, ERHIAccess::ReadOnlyExclusiveMask) && IsWritableAccess(Access);
	const bool bWriteAndRead = EnumHasAnyFlags(Access, ERHIAccess::WriteOnlyExclusiveMask) && IsReadableAccess(Access);
	return !bReadAndWrite && !bWriteAndRead;
}

/** "SRVCompute|UAVCompute"; "Unknown" for 0. The engine's GetRHIAccessName. */
DRYDOCK_API FString GetRHIAccessName(ERHIAccess Access);
