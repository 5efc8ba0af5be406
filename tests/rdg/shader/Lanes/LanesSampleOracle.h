// Samples of cubes, of flat textures, compared and gathered, by geometry and arithmetic in double that know nothing of
// the sampler: found by which texels of a cube touch each other, and by Direct3D's rules for coordinates.
#pragma once

#include "LanesResources.h"
#include "LanesTestTexture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace Drydock::Tests
{

using Lanes::TSamplePlace;
using Lanes::TSampling;
using FTexel = FTestTexture::FTexel;
using FPoint = std::array<double, 3>;

constexpr EKernelAddress GSampleAddresses[] = {
	EKernelAddress::Wrap, EKernelAddress::Clamp, EKernelAddress::Mirror, EKernelAddress::Border};
constexpr double GTie = 2e-3; // of 1/256 texel: coordinates so near to two of these may be snapped to either

class FSampleRandom
{
public:
	explicit FSampleRandom(uint32_t Seed)
		: Engine(Seed)
	{
	}
	int32_t Int(int32_t Low, int32_t High) { return std::uniform_int_distribution<int32_t>(Low, High)(Engine); }
	double Real(double Low, double High)
	{
		return double(float(std::uniform_real_distribution<double>(Low, High)(Engine)));
	}
	template<typename T, size_t Count>
	T Pick(const T (&From)[Count])
	{
		return From[Int(0, int32_t(Count) - 1)];
	}

private:
	std::mt19937 Engine;
};

/** Direct3D's table of faces: the point of a cube from -1 to 1 at columns S and rows T, both from -1 to 1. */
inline FPoint OnCube(int Face, double S, double T)
{
	const FPoint Points[6] = {{1, -T, -S}, {-1, -T, S}, {S, 1, T}, {S, -1, -T}, {S, -T, 1}, {-S, -T, -1}};
	return Points[Face];
}

inline double GetDistance(const FPoint& A, const FPoint& B)
{
	return std::max({std::abs(A[0] - B[0]), std::abs(A[1] - B[1]), std::abs(A[2] - B[2])});
}

struct FPlaceOnFace
{
	int Face;
	double S;
	double T;
};

/** The face with the longest axis, z before y before x. */
inline FPlaceOnFace FindFace(const FPoint& D)
{
	const double X = std::abs(D[0]), Y = std::abs(D[1]), Z = std::abs(D[2]);
	const int Axis = Z >= X && Z >= Y ? 2 : Y >= X ? 1 : 0;
	const int Face = 2 * Axis + (D[size_t(Axis)] < 0);
	const double Length = std::abs(D[size_t(Axis)]);
	// The plane's point, and what it has along the face's columns and rows.
	const FPoint P = {D[0] / Length, D[1] / Length, D[2] / Length};
	const FPoint Origin = OnCube(Face, 0, 0), Right = OnCube(Face, 1, 0), Down = OnCube(Face, 0, 1);
	FPlaceOnFace Result = {Face, 0, 0};
	for (size_t i = 0; i < 3; ++i)
	{
		Result.S += (P[i] - Origin[i]) * (Right[i] - Origin[i]);
		Result.T += (P[i] - Origin[i]) * (Down[i] - Origin[i]);
	}
	return Result;
}

/** What lies where a texel of a face would, up to one beyond its edges: found by which texels' edges and corners touch.
 */
inline FTexel ReadAround(FTestTexture& Cube, int Cubes, int Face, int X, int Y, int Mip)
{
	const int Size = Cube.Mips[size_t(Mip)].SizeX;
	const auto Centre = [Size](int i)
	{
		return (2.0 * i + 1) / Size - 1;
	};
	const bool bOutX = X < 0 || X >= Size;
	const bool bOutY = Y < 0 || Y >= Size;
	const double S = bOutX ? (X < 0 ? -1 : 1) : Centre(X);
	const double T = bOutY ? (Y < 0 ? -1 : 1) : Centre(Y);
	if (!bOutX && !bOutY)
	{
		return Cube.Read(X, Y, Cubes * 6 + Face, Mip);
	}
	const FPoint Touched = OnCube(Face, S, T);
	FTexel Sum = {};
	int Count = 0;
	for (int Other = 0; Other < 6; ++Other)
	{
		if (Other == Face && !(bOutX && bOutY))
		{
			continue; // of an edge only the texel beyond counts
		}
		for (int y = 0; y < Size; ++y)
		{
			for (int x = 0; x < Size; ++x)
			{
				bool bTouches = false;
				for (const double Side : {-1.0, 1.0})
				{
					const double EdgeX = Centre(x) + Side / Size;
					const double EdgeY = Centre(y) + Side / Size;
					const double OtherY = Centre(y) - Side / Size;
					bTouches = bTouches ||
							   GetDistance(Touched, OnCube(Other, EdgeX, bOutX && bOutY ? EdgeY : Centre(y))) < 1e-9 ||
							   GetDistance(Touched, OnCube(Other, bOutX && bOutY ? EdgeX : Centre(x),
														bOutX && bOutY ? OtherY : EdgeY)) < 1e-9;
				}
				if (bTouches)
				{
					const FTexel Texel = Cube.Read(x, y, Cubes * 6 + Other, Mip);
					for (size_t c = 0; c < 4; ++c)
					{
						Sum[c] += Texel[c];
					}
					++Count;
				}
			}
		}
	}
	EXPECT_EQ(bOutX && bOutY ? 3 : 1, Count);
	return {Sum[0] / Count, Sum[1] / Count, Sum[2] / Count, Sum[3] / Count};
}

inline int Address(int X, int Size, EKernelAddress Mode)
{
	const auto Modulo = [X](int Period)
	{
		return (X % Period + Period) % Period;
	};
	switch (Mode)
	{
	case EKernelAddress::Wrap:
		return Modulo(Size);
	case EKernelAddress::Mirror:
		return std::min(Modulo(2 * Size), 2 * Size - 1 - Modulo(2 * Size));
	case EKernelAddress::Clamp:
		return std::clamp(X, 0, Size - 1);
	default:
		return X < 0 || X >= Size ? -1 : X;
	}
}

/** First texel and weight of the second; nothing where rounding decides. */
struct FAxis
{
	int First;
	double Weight;
};
inline std::optional<FAxis> FindAxis(double Texels, bool bPoint)
{
	const double Fixed = Texels * 256 + 0.5;
	if (std::abs(Fixed - std::round(Fixed)) < GTie)
	{
		return {};
	}
	const double Snapped = std::floor(Fixed) / 256 - (bPoint ? 0 : 0.5);
	return FAxis{int(std::floor(Snapped)), bPoint ? 0 : Snapped - std::floor(Snapped)};
}

/** The same sample twice: as lanes are asked for it, and in double. */
struct FSampleCase
{
	FTestTexture* Texture = nullptr;
	FKernelSampler Sampler;
	bool bCube = false;
	bool bArray = false;
	bool bCompares = false;
	double At[4] = {}; // coordinates, and behind them the layer
	double Reference = 0;
	int Offset[2] = {};
	double Level = 0;

	int GetAxes() const { return bCube ? 3 : 2; }

	/** Left above, right above, left below, right below, and the weights of right and below. */
	struct FFour
	{
		FTexel Texels[4];
		double X;
		double Y;
	};
	std::optional<FFour> FindFour(int Mip, bool bPoint) const
	{
		const FKernelMip& M = Texture->Mips[size_t(Mip)];
		const FPlaceOnFace Place = bCube ? FindFace({At[0], At[1], At[2]}) : FPlaceOnFace{};
		const std::optional<FAxis> X =
			FindAxis(bCube ? (Place.S + 1) / 2 * M.SizeX : At[0] * M.SizeX + Offset[0], bPoint);
		const std::optional<FAxis> Y =
			FindAxis(bCube ? (Place.T + 1) / 2 * M.SizeY : At[1] * M.SizeY + Offset[1], bPoint);
		if (!X || !Y)
		{
			return {};
		}
		const int Layers = bCube ? M.SizeZ / 6 : M.SizeZ;
		const int Layer = bArray ? int(std::clamp(std::nearbyint(At[GetAxes()]), 0.0, Layers - 1.0)) : 0;
		FFour Four = {{}, X->Weight, Y->Weight};
		for (int k = 0; k < 4; ++k)
		{
			const int x = X->First + (k & 1);
			const int y = Y->First + (k >> 1);
			FTexel& Texel = Four.Texels[k];
			if (bCube)
			{
				const int Last = M.SizeX - 1;
				Texel = bPoint ? Texture->Read(std::min(x - (k & 1), Last), std::min(y - (k >> 1), Last),
									 Layer * 6 + Place.Face, Mip)
							   : ReadAround(*Texture, Layer, Place.Face, x, y, Mip);
			}
			else
			{
				const int Column = Address(x, M.SizeX, Sampler.AddressU);
				const int Row = Address(y, M.SizeY, Sampler.AddressV);
				const float* B = Sampler.Border;
				Texel = Column < 0 || Row < 0 ? FTexel{B[0], B[1], B[2], B[3]} : Texture->Read(Column, Row, Layer, Mip);
			}
			if (bCompares)
			{
				Texel = {double(Sampler.Compare == EKernelCompare::Less && Reference < Texel[0]), 0, 0, 0};
			}
		}
		return Four;
	}

	std::optional<FTexel> Sample(int Mip) const
	{
		const std::optional<FFour> Four = FindFour(Mip, Sampler.Filter == EKernelFilter::Point);
		if (!Four)
		{
			return {};
		}
		FTexel Result;
		for (size_t c = 0; c < 4; ++c)
		{
			const double Above = Four->Texels[0][c] * (1 - Four->X) + Four->Texels[1][c] * Four->X;
			const double Below = Four->Texels[2][c] * (1 - Four->X) + Four->Texels[3][c] * Four->X;
			Result[c] = Above * (1 - Four->Y) + Below * Four->Y;
		}
		return Result;
	}

	template<typename Real>
	struct TArguments
	{
		Real At[4];
		Real Reference;
		Real Level;
		int32_t Offset[2];
		TSamplePlace<Real> Place;
	};
	template<typename Real>
	void Fill(TArguments<Real>& Out) const
	{
		Out.Reference = Real(Reference);
		Out.Level = Real(Level);
		Out.Place.bCube = bCube;
		Out.Place.Reference = bCompares ? &Out.Reference : nullptr;
		for (int i = 0; i < 4; ++i)
		{
			Out.At[i] = Real(At[i]);
		}
		for (int Axis = 0; Axis < GetAxes(); ++Axis)
		{
			Out.Place.Coordinates[Axis] = &Out.At[Axis];
			if (Axis < 2 && (Offset[0] || Offset[1]))
			{
				Out.Offset[Axis] = Offset[Axis];
				Out.Place.Offsets[Axis] = &Out.Offset[Axis];
			}
		}
		Out.Place.Layer = bArray ? &Out.At[GetAxes()] : nullptr;
	}
	template<typename Real>
	std::array<Real, 4> RunSample() const
	{
		TArguments<Real> Arguments;
		Fill(Arguments);
		std::array<Real, 4> Out;
		TSampling<Real, 1>::Sample(Texture->Texture, Sampler, Arguments.Place, &Arguments.Level, true, Out.data());
		return Out;
	}
	template<typename Real>
	std::array<Real, 4> RunGather(int Component) const
	{
		TArguments<Real> Arguments;
		Fill(Arguments);
		std::array<Real, 4> Out;
		TSampling<Real, 1>::Gather(Texture->Texture, Sampler, Arguments.Place, Component, Out.data());
		return Out;
	}
};

inline FSampleCase MakeSampleCase(FSampleRandom& Random, FTestTexture& Texture, bool bCube)
{
	FSampleCase Case;
	Case.Texture = &Texture;
	Case.Sampler = MakeSampler(Random.Int(0, 2) ? EKernelFilter::Bilinear : EKernelFilter::Point, EKernelAddress::Wrap);
	Case.Sampler.AddressU = Random.Pick(GSampleAddresses);
	Case.Sampler.AddressV = Random.Pick(GSampleAddresses);
	Case.Sampler.Border[0] = 0.5f;
	Case.Sampler.Border[3] = 0.25f;
	Case.bCube = bCube;
	Case.bArray = Random.Int(0, 1) != 0;
	for (double& Coordinate : Case.At)
	{
		Coordinate = Random.Real(-2, 3);
	}
	Case.At[Case.GetAxes()] = Random.Int(0, 3) ? Random.Real(-1, 4) : Random.Int(-2, 6) / 2.0; // ties between layers
	return Case;
}

} // namespace Drydock::Tests
