// Follows a scene's NaN and infinities: the passes that spread them, and the pixels of the final picture that have
// them.
#pragma once

#include "Diagnostics.h"
#include "Picture/Picture.h"
#include "SceneFile/NonFinite.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class FRDGPass;
class FRDGTexture;

namespace Drydock
{

/** The pixels of a pass that are not finite. */
struct FNonFiniteFootprint
{
	std::string Pass;
	uint64_t Pixels = 0;    // of which a channel is not finite
	uint64_t NumPixels = 0; // all that it was to write

	double GetShare() const
	{
		return NumPixels == 0 ? 0.0 : static_cast<double>(Pixels) / static_cast<double>(NumPixels);
	}
};

/** The final picture against that of the same frame with 0 in place of what is not finite, in pixels. */
struct FNonFiniteFinal
{
	uint64_t NumPixels = 0;
	uint64_t Changed = 0;   // another value in any channel
	uint64_t White = 0;     // red, green and blue at 1 or above, and not so with 0 in place
	uint64_t NotFinite = 0; // in any channel
};

/** Empty of a scene whose colour is finite, and with a policy other than to let it pass on. */
struct FNonFiniteSpread
{
	/** In the order in which they ran: each has a larger share than all before it. */
	std::vector<FNonFiniteFootprint> Passes;
	/** Absent where plugins take part: they may keep a history, and a second frame would be in it. */
	std::optional<FNonFiniteFinal> Final;
};

/** Over the pass's Output rect where it has one, else the whole of the texture's first mip; none of a texture whose
 * format holds no such value. Right after the pass. */
FNonFiniteFootprint CountNonFinitePixels(const FRDGPass& Pass, FRDGTexture& Written);

/** Keeps what spreads further than all passes before it. */
void AddFootprint(FNonFiniteSpread& Spread, FNonFiniteFootprint Footprint);

/** Both of one size. */
FNonFiniteFinal CompareFinal(const FPicture& Final, const FPicture& WithZeros);

/** The up to three passes that spread it most, and the final picture, in one warning. InFile: where it came from. */
FDiagnostic DescribeSpread(const FNonFiniteSpread& Spread, const std::vector<FNonFiniteChannel>& InFile);

FNonFiniteCount CountNonFinite(const FPicture& Picture);

/** A warning, or an error when that is the policy. File: that it is of; empty: of none. */
FDiagnostic DescribeNonFinite(const FNonFiniteChannel& Channel, const std::string& File);

} // namespace Drydock
