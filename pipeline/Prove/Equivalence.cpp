// The list of equivalences: one joins by an entry here, and the tests and `drydock prove` run it.
#include "Prove/Equivalence.h"

namespace Drydock
{

namespace
{

const char* const Races =
	"threads of one dispatch write one texel or buffer element, or add to it without an atomic, and their order "
	"decides the value: give each thread a place of its own, or add whole numbers with InterlockedAdd";
const char* const Beside = "a draw or dispatch depends on something that the cache of passes does not see: its shader "
						   "was bound by code of its "
						   "own, or texels were written by a kept address without a call of FRHITexture::Touch";
const char* const Memory =
	"a pass uses memory that is not its own: it uses a resource by a pointer, undeclared in its parameters, after the "
	"last pass that declares it or before the first that writes it";
const char* const Unwritten =
	"something is read that nothing wrote: a target that was not drawn as a whole, an UAV that only some threads store "
	"to, or a buffer without contents. Draw all of it, clear it, or read only what was drawn";
const char* const LeftOut =
	"a pass that nobody reads, or an effect without strength, has an effect on the picture all the same: its output is "
	"not declared, or its code keeps something beside the graph";
const char* const Rects =
	"a shader takes its place from the texture's extent, or from pixel (0, 0), and not from the view's rect: use the "
	"viewport's UVViewportMin and UVViewportSize, and clamp samples to UVViewportBilinearMin and -Max";
const char* const Views = "something is shared by the views, or sized and placed by the whole picture: keep textures "
						  "and state for each view, "
						  "and take sizes from the view's rect";

const char* const Exposed =
	"scene colour is multiplied by View.PreExposure: a pass compares or bends it as if it were not, or multiplies by "
	"the "
	"pre-exposure once more. Multiply by View.OneOverPreExposure before, and by View.PreExposure behind";
const char* const Lopsided =
	"samples are off by a part of a texel: texel centres lie at one half, (Pixel + 0.5) / Size. An effect that has a "
	"direction, or reads velocities or places in the world, differs on purpose";
const char* const Placed = "a pass takes something from the place of the pixel besides its inputs. Noise, patterns, "
						   "vignettes and places in the world do so on purpose";

/** 1/64 is the narrowest level of the bloom's chain, and its rows are blurred at half that width: corners at multiples
 * of these stay whole pixels on every level. */
constexpr std::array<int, 4> WholeOnEveryLevel = {128, 64, 37, 51};
constexpr std::array<int, 4> NotPadded = {0, 0, 0, 0};
constexpr std::array<int, 4> BeyondRightAndBelow = {0, 0, 1, 3};

FEquivalence Same(const char* Name, const char* What, std::vector<std::string> Variables, const char* Likely)
{
	return {Name, What, {}, {.Variables = std::move(Variables)}, EAlike::SameBits, Likely};
}

FEquivalence Laid(
	const char* Name, const char* What, const std::array<int, 4>& Padding, std::optional<double> ScreenPercentage = {})
{
	return {Name, What, {.Padding = NotPadded, .ScreenPercentage = ScreenPercentage},
		{.Padding = Padding, .ScreenPercentage = ScreenPercentage}, EAlike::SameButForRounding, Rects};
}

FEquivalence Split(const char* Name, const char* What, EViewLayout Alone, EViewLayout Together)
{
	return {Name, What, {.Layout = Alone}, {.Layout = Together}, EAlike::SameBits, Views};
}

std::vector<FEquivalence> MakeEquivalences()
{
	return {
		Same("SecondRun", "once more in the same process", {},
			"an extension keeps something from one frame to the next: in a static variable, or in a member"),
		{"Reused", "passes taken from the frame before", {}, {.bReuse = true}, EAlike::SameBits, Beside},
		Same("OneThread", "on one thread", {"r.Drydock.Threads=1"}, Races),
		Same("TwoThreads", "on two threads", {"r.Drydock.Threads=2"}, Races),
		Same("SevenThreads", "on seven threads", {"r.Drydock.Threads=7"}, Races),
		Same("FourLanes", "four pixels at a time", {"r.Drydock.LaneWidth=4"}, Races),
		Same("EightLanes", "eight pixels at a time", {"r.Drydock.LaneWidth=8"}, Races),
		Same("ShadersOnly", "without hand-written kernels", {"r.Drydock.NativeKernels=0"},
			"a hand-written kernel and the shader that it replaces compute different values"),
		// TransientAllocator 0 puts every texture into memory of its own; ExtendResourceLifetimes keeps the heap,
		// unshared.
		Same("NoTransientHeap", "every texture in memory of its own", {"r.RDG.TransientAllocator=0"}, Memory),
		Same("NoAliasing", "no memory used twice", {"r.RDG.Debug.ExtendResourceLifetimes=1"}, Memory),
		Same("NoMerging", "render passes not merged", {"r.RDG.MergeRenderPasses=0"},
			"a pass relies on what the pass before left in a target that it does not load"),
		Same("NoCulling", "passes that nobody reads run too", {"r.RDG.CullPasses=0"}, LeftOut),
		{"NoSkip", "nothing left out", {}, {.bNoSkip = true}, EAlike::SameBits, LeftOut},
		Same("ImmediateMode", "each pass runs when it is added", {"r.RDG.ImmediateMode=1"},
			"a lambda reads what the code behind AddPass changes: capture by value what the pass is to use"),
		Same("Clobbered1000", "memory that nothing wrote is 1000", {"r.RDG.ClobberResources=1"}, Unwritten),
		Same("ClobberedNaN", "memory that nothing wrote is NaN", {"r.RDG.ClobberResources=2"}, Unwritten),
		Same("ClobberedInf", "memory that nothing wrote is infinite", {"r.RDG.ClobberResources=3"}, Unwritten),
		// With less, dark halves are denormal and keep fewer bits.
		{"PreExposure", "stored with pre-exposure 4 and 16", {.Variables = {"r.EyeAdaptation.PreExposureOverride=4"}},
			{.Variables = {"r.EyeAdaptation.PreExposureOverride=16"}}, EAlike::SameButForRounding, Exposed, 4.0},
		{"Mirrored", "a plugin's pass on mirrored inputs", {}, {}, EAlike::SameBits, Lopsided, 1.0,
			EPassTransform::Mirrored},
		{"Shifted", "a plugin's pass on inputs moved by 8 texels", {}, {}, EAlike::SameBits, Placed, 1.0,
			EPassTransform::Shifted},
		Laid("OffsetRect", "at (128, 64) of a larger texture", WholeOnEveryLevel),
		Laid("PaddedExtent", "in the corner of a larger texture", BeyondRightAndBelow),
		Laid("HalfSizeOffset", "rendered at half the size, at (128, 64) of a larger texture", WholeOnEveryLevel, 50.0),
		Split(
			"SplitLeft", "the left half, alone and beside the right one", EViewLayout::Left, EViewLayout::LeftAndRight),
		Split("SplitRight", "the right half, alone and beside the left one", EViewLayout::Right,
			EViewLayout::RightAndLeft),
	};
}

/** A multiple of what the levels of a picture shrink by, where the picture is that wide. */
int FindMiddle(int Width)
{
	constexpr int Level = 64;
	return Width >= 2 * Level ? Width / 2 / Level * Level : Width / 2;
}

std::vector<FViewRect> MakeViewRects(EViewLayout Layout, const FViewRect& View)
{
	const int Middle = View[0] + FindMiddle(View[2] - View[0]);
	const FViewRect Left = {View[0], View[1], Middle, View[3]}, Right = {Middle, View[1], View[2], View[3]};
	switch (Layout)
	{
	case EViewLayout::Left:
		return {Left};
	case EViewLayout::LeftAndRight:
		return {Left, Right};
	case EViewLayout::Right:
		return {Right};
	case EViewLayout::RightAndLeft:
		return {Right, Left};
	case EViewLayout::AsConfigured:
		break;
	}
	return {};
}

} // namespace

const std::vector<FEquivalence>& GetEquivalences()
{
	static const std::vector<FEquivalence> Equivalences = MakeEquivalences();
	return Equivalences;
}

FRunOptions MakeEquivalentRun(const FRunOptions& Options, const FEquivalenceRun& Run, const FViewRect& View)
{
	FRunOptions Made = Options;
	Made.Variables.insert(Made.Variables.end(), Run.Variables.begin(), Run.Variables.end());
	Made.bNoSkip = Options.bNoSkip || Run.bNoSkip;
	Made.Padding = Run.Padding ? Run.Padding : Options.Padding;
	Made.ScreenPercentage = Run.ScreenPercentage ? Run.ScreenPercentage : Options.ScreenPercentage;
	if (Run.Layout != EViewLayout::AsConfigured)
	{
		Made.ViewRects = MakeViewRects(Run.Layout, View);
	}
	return Made;
}

FViewRect FindSharedView(const FEquivalenceRun& Run, const FViewRect& View)
{
	FViewRect Rect = View;
	FViewRect Corner = View;
	if (Run.Layout != EViewLayout::AsConfigured)
	{
		const std::vector<FViewRect> Rects = MakeViewRects(Run.Layout, View);
		Rect = Rects[0];
		Corner = Rects.size() > 1 ? View : Rect;
	}
	return {Rect[0] - Corner[0], Rect[1] - Corner[1], Rect[2] - Corner[0], Rect[3] - Corner[1]};
}

} // namespace Drydock
