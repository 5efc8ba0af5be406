// Counts what a pass cost, in units that do not depend on the machine.
#pragma once

#include "Diagnostics.h"
#include "Math/IntRect.h"
#include "Misc/EnumClassFlags.h"

#include <cstdint>
#include <string>
#include <vector>

class FRHITexture;

namespace Drydock
{

/** Texels of one mip of a texture that were drawn, cleared or copied to; of all its slices. */
struct FTextureWrite
{
	const FRHITexture* Texture = nullptr;
	int32_t Mip = 0;
	FIntRect Rect;
};

/** The ways of counting taps. */
enum class ETapCount : uint8_t
{
	Static,   // so many in each thread, by the shader's text
	Measured, // while it ran: threads differ
	Unknown,  // a hand-written kernel ran in place of a shader whose threads differ
};

/** The runners of a pass's shaders; flags. */
enum class EShaderRun : uint8_t
{
	None = 0,
	NativeKernel = 1, // a hand-written kernel
	Shader = 2,       // the .usf, compiled
	Interpreter = 4,  // a vertex shader's SPIR-V
	Backend = 8       // r.Drydock.Backend
};
ENUM_CLASS_FLAGS(EShaderRun)

/** "native kernel", "shader", "interpreter", "Vulkan"; several with commas between; empty: None. */
DRYDOCK_API std::string DescribeShaderRun(EShaderRun Ran);

/** Sums over the dispatches and draws of a pass. */
struct FPassCounters
{
	std::string Shader;                     // class of the last shader that ran: "FBloomSetupPS"; empty: none did
	std::string Entry;                      // its entry point
	EShaderRun Ran = EShaderRun::None;      // how
	uint32_t Dispatches = 0;                // draws of shaders, and dispatches
	uint32_t Reused = 0;                    // of these, results that were taken from a cache
	std::string NotReusable;                // why the cache was not asked, or kept nothing; of the last of them
	uint64_t Pixels = 0;                    // pixels drawn, threads dispatched, texels copied or cleared
	uint64_t Taps = 0;                      // texture samples, gathers and loads
	ETapCount TapCount = ETapCount::Static; // of Taps; of several dispatches, the last of its values
	uint64_t BytesRead = 0;                 // of every view bound for reading, each texel once
	/** Bytes of every texel written; of views bound for writing by compute shaders: at most all of them. */
	uint64_t BytesWritten = 0;
	/** The texels that draws, clears and copies wrote, each texture's mip once, as the smallest rect around them. The
	 * texels that a compute shader stores are not known. */
	std::vector<FTextureWrite> Writes;
	std::vector<FDiagnostic> Remarks; // warnings of draws

	void AddWrite(const FRHITexture* Texture, int32_t Mip, const FIntRect& Rect);
	void Rename(const FRHITexture* From, const FRHITexture* To);
	/** Each text once. */
	void AddRemark(const FDiagnostic& Remark);
};

} // namespace Drydock
