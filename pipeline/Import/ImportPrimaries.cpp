// Derives colour matrices. Sources: SMPTE RP 177 (primaries to XYZ), ITU-R BT.709, the Bradford adaptation (Lam 1985).
#include "Import/ImportPrimaries.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

using FColor = std::array<double, 3>;

const std::vector<float>& GetRec709()
{
	static const std::vector<float> Rec709 = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
	return Rec709;
}

FColorMatrix Multiply(const FColorMatrix& A, const FColorMatrix& B)
{
	FColorMatrix Product = {};
	for (size_t Row = 0; Row < 3; ++Row)
	{
		for (size_t Column = 0; Column < 3; ++Column)
		{
			for (size_t Index = 0; Index < 3; ++Index)
			{
				Product[Row][Column] += A[Row][Index] * B[Index][Column];
			}
		}
	}
	return Product;
}

FColor Multiply(const FColorMatrix& A, const FColor& Color)
{
	FColor Product = {};
	for (size_t Row = 0; Row < 3; ++Row)
	{
		Product[Row] = A[Row][0] * Color[0] + A[Row][1] * Color[1] + A[Row][2] * Color[2];
	}
	return Product;
}

/** None where the matrix has no inverse. */
std::optional<FColorMatrix> Invert(const FColorMatrix& A)
{
	const auto Minor = [&A](size_t Row, size_t Column)
	{
		const size_t R1 = (Row + 1) % 3;
		const size_t R2 = (Row + 2) % 3;
		const size_t C1 = (Column + 1) % 3;
		const size_t C2 = (Column + 2) % 3;
		return A[R1][C1] * A[R2][C2] - A[R1][C2] * A[R2][C1];
	};
	const double Determinant = A[0][0] * Minor(0, 0) + A[0][1] * Minor(0, 1) + A[0][2] * Minor(0, 2);
	if (!(std::abs(Determinant) > 1e-9))
	{
		return std::nullopt;
	}
	FColorMatrix Inverse = {};
	for (size_t Row = 0; Row < 3; ++Row)
	{
		for (size_t Column = 0; Column < 3; ++Column)
		{
			Inverse[Row][Column] = Minor(Column, Row) / Determinant;
		}
	}
	return Inverse;
}

/** XYZ of a chromaticity at luminance 1. */
FColor ToXyz(double X, double Y)
{
	return {X / Y, 1.0, (1.0 - X - Y) / Y};
}

FColor GetWhite(const std::vector<float>& Chromaticities)
{
	return ToXyz(static_cast<double>(Chromaticities[6]), static_cast<double>(Chromaticities[7]));
}

std::optional<FColorMatrix> MakeToXyz(const std::vector<float>& Chromaticities)
{
	FColorMatrix Columns = {};
	for (size_t Primary = 0; Primary < 3; ++Primary)
	{
		const double X = static_cast<double>(Chromaticities[2 * Primary]);
		const double Y = static_cast<double>(Chromaticities[2 * Primary + 1]);
		const FColor Part = {X, Y, 1.0 - X - Y};
		for (size_t Row = 0; Row < 3; ++Row)
		{
			Columns[Row][Primary] = Part[Row];
		}
	}
	const std::optional<FColorMatrix> Inverse = Invert(Columns);
	if (!Inverse)
	{
		return std::nullopt;
	}
	const FColor Scale = Multiply(*Inverse, GetWhite(Chromaticities));
	for (size_t Row = 0; Row < 3; ++Row)
	{
		for (size_t Primary = 0; Primary < 3; ++Primary)
		{
			Columns[Row][Primary] *= Scale[Primary];
		}
	}
	return Columns;
}

FColorMatrix MakeAdaptation(const FColor& From, const FColor& To)
{
	const FColorMatrix Bradford = {{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
	const FColor Source = Multiply(Bradford, From);
	const FColor Target = Multiply(Bradford, To);
	FColorMatrix Scaled = Bradford;
	for (size_t Row = 0; Row < 3; ++Row)
	{
		for (double& Value : Scaled[Row])
		{
			Value *= Target[Row] / Source[Row];
		}
	}
	return Multiply(*Invert(Bradford), Scaled);
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
	return Multiply(*Invert(*MakeToXyz(Rec709)), Multiply(Adaptation, *ToXyz));
}

} // namespace Drydock
