// Derives colour matrices. Sources: SMPTE RP 177 (primaries to XYZ), ITU-R BT.709.
#include "Import/ImportPrimaries.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

const std::vector<float>& GetRec709()
{
	static const std::vector<float> Rec709 = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
	return Rec709;
}

FColorVector GetWhite(const std::vector<float>& Chromaticities)
{
	return MakeWhite(static_cast<double>(Chromaticities[6]), static_cast<double>(Chromaticities[7]));
}

std::optional<FColorMatrix> MakeToXyz(const std::vector<float>& Chromaticities)
{
	FColorMatrix Columns = {};
	for (size_t Primary = 0; Primary < 3; ++Primary)
	{
		const double X = static_cast<double>(Chromaticities[2 * Primary]);
		const double Y = static_cast<double>(Chromaticities[2 * Primary + 1]);
		const FColorVector Part = {X, Y, 1.0 - X - Y};
		for (size_t Row = 0; Row < 3; ++Row)
		{
			Columns[Row][Primary] = Part[Row];
		}
	}
	if (!(std::abs(GetDeterminant(Columns)) > 1e-9))
	{
		return std::nullopt;
	}
	const FColorVector Scale = Multiply(Invert(Columns), GetWhite(Chromaticities));
	for (size_t Row = 0; Row < 3; ++Row)
	{
		for (size_t Primary = 0; Primary < 3; ++Primary)
		{
			Columns[Row][Primary] *= Scale[Primary];
		}
	}
	return Columns;
}

} // namespace

std::optional<FColorMatrix> MakeRec709Matrix(const std::vector<float>& Chromaticities)
{
	const std::vector<float>& Rec709 = GetRec709();
	const bool bUsable = Chromaticities.size() == 8 && Chromaticities[7] > 0.0f &&
						 std::ranges::all_of(Chromaticities, [](float Value) { return std::isfinite(Value); });
	const bool bSame = bUsable && std::equal(Chromaticities.begin(), Chromaticities.end(), Rec709.begin(),
									  [](float A, float B) { return std::abs(A - B) <= 0.001f; });
	const std::optional<FColorMatrix> ToXyz = bUsable && !bSame ? MakeToXyz(Chromaticities) : std::nullopt;
	if (!ToXyz)
	{
		return std::nullopt;
	}
	const FColorMatrix Adaptation = MakeAdaptation(GetWhite(Chromaticities), GetWhite(Rec709));
	return Multiply(Invert(*MakeToXyz(Rec709)), Multiply(Adaptation, *ToXyz));
}

} // namespace Drydock
