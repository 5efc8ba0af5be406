// Lists the blurs that a study can compare and the formats in which they store.
#include "Budget/BlurNames.h"

#include "RangeTools.h"

namespace Drydock
{

const std::vector<FBlurAlgorithm>& GetBlurAlgorithms()
{
	static const std::vector<FBlurAlgorithm> Algorithms = {
		{"Exact", "True Gaussian convolution in double, cut where double ends: the reference.", false},
		{"Direct", "All taps of a square at once, 3 deviations to each side.", true, 0.5, 8.0},
		{"Separable", "Rows, then columns, 3 deviations to each side."},
		{"GaussianSum",
			"One Gaussian of the engine's bloom: on a level of the chain, in at most 32 taps, stretched back.", true,
			1.5, 1000.0},
		{"Kawase", "Passes of four taps at full size, each further out.", true, 0.5, 250.0},
		{"DualKawase", "Halved and doubled again by 5 and 8 taps.", true, 1.0, 426.0},
		{"Pyramid", "[1 3 3 1] down and up, a small separable Gaussian between."},
		{"FFT", "The bloom's convolution by Fourier transforms, with a Gaussian for its kernel; the edge repeated "
				"around it."},
	};
	return Algorithms;
}

const FBlurAlgorithm* FindBlurAlgorithm(const std::string& Name)
{
	const std::vector<FBlurAlgorithm>& Algorithms = GetBlurAlgorithms();
	return FindItem(Algorithms, Name, &FBlurAlgorithm::Name);
}

const std::vector<std::string>& GetBlurStorages()
{
	static const std::vector<std::string> Storages = {"float32", "float16", "R11G11B10", "8bit"};
	return Storages;
}

} // namespace Drydock
