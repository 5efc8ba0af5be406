// Keeps the textures that the passes of a frame wrote, for a second frame that is compared with it pass by pass.
#pragma once

#include "Picture/Picture.h"
#include "Prove/Equivalence.h"
#include "Run/PassWrites.h"

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace Drydock
{

/** Two values of one pixel that differ. */
struct FPixelDifference
{
	int X = 0; // from the corner of what was drawn
	int Y = 0;
	std::vector<double> Base; // all channels
	std::vector<double> Other;
	uint64_t NumPixels = 0; // that differ, in all
};

/** The same bits, or within one step of 8 bits; of values above 1 relative to them. */
bool AreClose(double A, double B);

/** "32 x 8". */
std::string FormatSize(const FPicture& Picture);

/** None: the pictures are alike. Both of one size and number of channels (checked). */
DRYDOCK_API std::optional<FPixelDifference> ComparePixels(const FPicture& Base, const FPicture& Other, EAlike Alike);

/** The first pass that wrote something else. */
struct FFirstDifference
{
	std::string Pass;
	std::string Shader;
	std::string Owner; // the plugin that added it; empty: none
	std::string Resource;
	int Mip = 0;
	std::string Sizes;                     // where it drew another size: "32 x 8, and 64 x 8"; else empty
	std::optional<FPixelDifference> Pixel; // else
	std::vector<std::string> PartlyDrawn; // what it reads and of which only a part was written: "Half: 3 x 5 of 6 x 5",
										  // "Out: by pass P, all but 7 pixels (the first is (8, 0))"
};

/** One frame's passes, and in a second one the first that differs. */
class DRYDOCK_API FPassRecord
{
public:
	/** Alike: the likeness of the frames; for textures that passes write in between only the size of differences is
	 * judged, not their number. bClobbered: the second frame's memory is filled, so that texels that no pass wrote
	 * differ. Scale: values of the second frame may be this multiple. */
	FPassRecord(EAlike InAlike, bool bInClobbered, double InScale = 1.0);

	/** Called with the passes of the base frame. */
	void Keep(const FPassWrites& Writes);
	/** Called with the passes of the other frame, later. */
	void Compare(const FPassWrites& Writes);

	const std::optional<FFirstDifference>& GetDifference() const { return Difference; }

private:
	/** Pass, which of that name, texture, mip. */
	using FKey = std::tuple<std::string, int, std::string, int>;

	struct FDrawn
	{
		FPicture Picture;
		bool bRaster = false; // all of the window was drawn
	};

	static int CountEarlier(const FPassWrites& Writes, std::map<std::string, int>& Executed);
	void NotePartlyDrawn(const FPassWrites& Writes);

	const EAlike Alike;
	const bool bClobbered;
	const double Scale;
	std::map<FKey, FDrawn> Kept;
	std::map<std::string, int> KeptByName; // passes of that name that ran
	std::map<std::string, int> ComparedByName;
	std::map<std::string, std::string> Partly; // by texture: what was written of it
	std::optional<FFirstDifference> Difference;
};

} // namespace Drydock
