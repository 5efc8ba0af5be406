// One pass of a run under the hazards: its shader is run beside the frame with other pictures in place of its input,
// and with other numbers in place of its parameters.
#pragma once

#include "DispatchObserver.h"
#include "Hazards/Hazards.h"
#include "Picture/ImageFile.h"

#include <array>
#include <string>
#include <vector>

namespace Drydock
{

/** The result of a pass with one hazard, beside its result for the same picture without it. */
struct FHazardFinding
{
	std::string Hazard; // "NaN"; of a parameter "Strength = -1"
	std::string File;   // of its picture: "NaN"
	FImage Result;      // RGBA, the first thing that the pass writes
	uint64_t NumPixels = 0;
	uint64_t NumNaN = 0;      // pixels of which a channel is NaN
	uint64_t NumInfinite = 0; // pixels of which a channel is infinite
	uint64_t NumNegative = 0; // of which red, green or blue is below 0
	uint64_t NumChanged = 0;  // that differ from the clean result
	int Reach = -1;     // farthest changed pixel from the bad one, along x or y; -1: none, or there is no such pixel
	double Least = 0.0; // of finite colours
	double Most = 0.0;
	bool bFlat = false;    // every pixel has the value of the first
	bool bAsInput = false; // bits of the input, as its format stores it
};

/** A colour that was everywhere in the input, and what the middle of the output became. */
struct FHazardTone
{
	std::string Name; // "mid grey"
	std::array<double, 3> In = {};
	std::array<double, 3> Out = {};
	std::string Says; // "as it was", "as sRGB encodes it", ...
};

/** A dispatch or draw of the pass. */
struct FHazardRow
{
	std::string Pass;
	std::string Shader;
	std::string Input; // the texture that the pictures are in place of
	int Width = 0;     // of that
	int Height = 0;
	std::vector<FHazardFinding> Findings;
	std::vector<FHazardTone> Tones;
};

struct FHazardRequest
{
	std::string Pass;  // pattern with * and ?, of a pass's name or its shader's; empty: all passes of plugins
	std::string Input; // as the shader calls it; empty: the first that has red, green and blue
};

class DRYDOCK_API FHazardCapture final : public IDispatchObserver
{
public:
	explicit FHazardCapture(FHazardRequest InRequest);
	~FHazardCapture() override;

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** One at least; none where no pass is named and those of plugins read no picture. Throws FError (DD1020): no pass
	 * fits, or none reads such a texture. */
	const std::vector<FHazardRow>& GetRows() const;

private:
	const FHazardRequest Request;
	std::vector<FHazardRow> Rows;
	bool bPluginRan = false;         // a pass of a plugin did
	std::vector<std::string> Passes; // all that ran a shader
	std::vector<std::string> Inputs; // textures of those that fit
};

/** A line for each hazard: what spread, what stayed, what became NaN. */
DRYDOCK_API std::string MakeHazardText(const FHazardRow& Row, int Width = 0);
DRYDOCK_API std::string MakeHazardJson(const std::vector<FHazardRow>& Rows);

/** Whether a picture that is finite became NaN: what `drydock hazards` counts as found. */
DRYDOCK_API bool MakesNaNOfFinite(const FHazardFinding& Finding);

/** Describes in a few words what became of a colour; empty: nothing known. */
DRYDOCK_API std::string DescribeTone(const std::array<double, 3>& In, const std::array<double, 3>& Out);

/** Describes a finding: "spreads 2 pixels far: 25 of 4096 are NaN". */
DRYDOCK_API std::string DescribeFinding(const FHazardFinding& Finding);

} // namespace Drydock
