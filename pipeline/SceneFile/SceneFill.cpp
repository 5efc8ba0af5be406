// Takes values from planes, mends what policies ask for, and packs them into texels.
#include "SceneFile/SceneFill.h"

#include "Picture/ImagePlane.h"
#include "TileExecutor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Drydock
{

namespace
{

/** The values of the file's pixels, as the policies leave them. */
class FFileValues
{
public:
	explicit FFileValues(const FSceneFillInputs& InInputs)
		: Inputs(InInputs)
		, Limit(&InInputs.Packing == &GetScenePackings().front() ? GetSceneColorClamp() : HUGE_VALF)
		, bZero(GetNonFinitePolicy() == ENonFinitePolicy::Zero)
		, bDepth(InInputs.Packing.Format == PF_DepthStencil)
	{
	}

	/** Counts: what is not finite is added. */
	FScenePackValues Get(int X, int Y, FNonFiniteSlots& Counts) const
	{
		FScenePackValues Values = {};
		for (size_t Slot = 0; Slot < Inputs.Sources.size(); ++Slot)
		{
			const FSceneFillSource& Source = Inputs.Sources[Slot];
			Values[Slot] = Source.Plane != nullptr ? Source.Plane->Get(GetIndex(X, Y)) : Source.Default;
		}
		Mend(Values, X, Y, Counts);
		return Values;
	}

	/** Reads a row of pixels from X on. */
	void GetRow(int X, int Y, std::vector<FScenePackValues>& Row, FNonFiniteSlots& Counts) const
	{
		for (size_t Slot = 0; Slot < Inputs.Sources.size(); ++Slot)
		{
			const FSceneFillSource& Source = Inputs.Sources[Slot];
			size_t Index = GetIndex(X, Y);
			for (FScenePackValues& Values : Row)
			{
				Values[Slot] = Source.Plane != nullptr ? Source.Plane->Get(Index++) : Source.Default;
			}
		}
		for (size_t Index = 0; Index < Row.size(); ++Index)
		{
			Mend(Row[Index], X + static_cast<int>(Index), Y, Counts);
		}
	}

private:
	size_t GetIndex(int X, int Y) const
	{
		return static_cast<size_t>(Y) * static_cast<size_t>(Inputs.Width) + static_cast<size_t>(X);
	}

	void Mend(FScenePackValues& Values, int X, int Y, FNonFiniteSlots& Counts) const
	{
		for (size_t Slot = 0; Slot < Inputs.Sources.size(); ++Slot)
		{
			float& Value = Values[Slot];
			if (Slot < 3 && std::abs(Value) > Limit)
			{
				Value = std::copysign(Limit, Value);
			}
			if (IsBad(Value))
			{
				Counts[Slot].Add(X, Y);
				Value = !bZero ? Value : bDepth ? FindBeside(Slot, X, Y) : 0.0f;
			}
		}
	}

	/** Depth that is infinitely far is where nothing is. */
	bool IsBad(float Value) const { return !std::isfinite(Value) && !(bDepth && Value > 0.0f); }

	/** No depth is 0: the nearest in the row, left before right; infinitely far where there is none nearby. */
	float FindBeside(size_t Slot, int X, int Y) const
	{
		constexpr int Farthest = 64; // pixels
		for (int Distance = 1; Distance <= Farthest; ++Distance)
		{
			for (const int Other : {X - Distance, X + Distance})
			{
				const bool bInRow = Other >= 0 && Other < Inputs.Width;
				const float Value = bInRow ? Inputs.Sources[Slot].Plane->Get(GetIndex(Other, Y)) : NAN;
				if (!IsBad(Value))
				{
					return Value;
				}
			}
		}
		return HUGE_VALF;
	}

	const FSceneFillInputs& Inputs;
	const float Limit;
	const bool bZero;
	const bool bDepth;
};

/** The file's values at one pixel of a texture at another resolution. */
class FPixelSource
{
public:
	FPixelSource(const FSceneRegion& Region, bool bInArea)
		: bArea(bInArea)
		, Corner(Region.Source.Min)
	{
		for (int32 X = 0; X < Region.Target.Width(); ++X)
		{
			Columns.push_back(Choose(Region.Source.Width(), Region.Target.Width(), X));
		}
		for (int32 Y = 0; Y < Region.Target.Height(); ++Y)
		{
			Rows.push_back(Choose(Region.Source.Height(), Region.Target.Height(), Y));
		}
	}

	/** GetValues: of a pixel of the file. One source pixel alone comes through bit for bit. */
	template<typename TFunction>
	FScenePackValues Get(int32 X, int32 Y, TFunction&& GetValues) const
	{
		const FCoverage& Column = Columns[static_cast<size_t>(X)];
		const FCoverage& Row = Rows[static_cast<size_t>(Y)];
		if (Column.Parts.size() == 1 && Row.Parts.size() == 1)
		{
			return GetValues(Corner.X + Column.First, Corner.Y + Row.First);
		}
		std::array<double, std::tuple_size_v<FScenePackValues>> Sums = {};
		for (size_t J = 0; J < Row.Parts.size(); ++J)
		{
			for (size_t I = 0; I < Column.Parts.size(); ++I)
			{
				const FScenePackValues Values = GetValues(
					Corner.X + Column.First + static_cast<int32>(I), Corner.Y + Row.First + static_cast<int32>(J));
				for (size_t Slot = 0; Slot < Sums.size(); ++Slot)
				{
					Sums[Slot] += static_cast<double>(Values[Slot]) * Column.Parts[I] * Row.Parts[J];
				}
			}
		}
		FScenePackValues Means = {};
		std::transform(Sums.begin(), Sums.end(), Means.begin(), [](double Sum) { return static_cast<float>(Sum); });
		return Means;
	}

private:
	FCoverage Choose(int SourceSize, int TargetSize, int Index) const
	{
		return bArea ? MakeCoverage(SourceSize, TargetSize, Index)
					 : FCoverage{FindCenterPixel(SourceSize, TargetSize, Index), {1.0}};
	}

	bool bArea;
	FIntPoint Corner;
	std::vector<FCoverage> Columns;
	std::vector<FCoverage> Rows;
};

/** One row of the texture on its way. */
class FRowFill
{
public:
	explicit FRowFill(const FSceneFillInputs& InInputs)
		: Inputs(InInputs)
		, Values(InInputs)
	{
		for (const FSceneRegion& Region : Inputs.Regions)
		{
			const bool bSame = Region.Source.Size() == Region.Target.Size();
			Scaled.push_back(bSame ? nullptr : std::make_unique<FPixelSource>(Region, Inputs.Packing.bMeanOfArea));
		}
	}

	/** Row: of the whole texture. */
	void Fill(int32 Y, TArray<FLinearColor>& Row, FNonFiniteSlots& Counts) const
	{
		for (size_t Index = 0; Index < Scaled.size(); ++Index)
		{
			const FSceneRegion& Region = Inputs.Regions[Index];
			const FIntRect Target = Region.Target + Inputs.Corner;
			if (Y < Target.Min.Y || Y >= Target.Max.Y)
			{
				continue;
			}
			std::vector<FScenePackValues> Source(static_cast<size_t>(Target.Width()));
			const int32 RowOfRegion = Y - Target.Min.Y;
			if (Scaled[Index] == nullptr)
			{
				Values.GetRow(Region.Source.Min.X, Region.Source.Min.Y + RowOfRegion, Source, Counts);
			}
			else
			{
				for (int32 X = 0; X < Target.Width(); ++X)
				{
					Source[static_cast<size_t>(X)] = Scaled[Index]->Get(X, RowOfRegion,
						[&](int32 SourceX, int32 SourceY) { return Values.Get(SourceX, SourceY, Counts); });
				}
			}
			for (int32 X = 0; X < Target.Width(); ++X)
			{
				Row[Target.Min.X + X] = Inputs.Packing.Pack(Source[static_cast<size_t>(X)], Inputs.Context);
			}
		}
	}

private:
	const FSceneFillInputs& Inputs;
	FFileValues Values;
	std::vector<std::unique_ptr<FPixelSource>> Scaled; // by region; null: pixel for pixel
};

} // namespace

FNonFiniteSlots FillSceneTexture(FRHITexture& Texture, const FSceneFillInputs& Inputs)
{
	const FRowFill Rows(Inputs);
	const FIntPoint Extent = Texture.GetSizeXY();
	std::vector<FNonFiniteSlots> RowCounts(static_cast<size_t>(Extent.Y));
	Texture.EnsureMemory();
	ForEachTile(FKernelTile{0, 0, 0, Extent.X, Extent.Y, 1}, FIntPoint(Extent.X, 16),
		[&](const FKernelTile& Tile)
		{
			TArray<FLinearColor> Row;
			for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				Row.Init(Inputs.Packing.Outside, Extent.X);
				Rows.Fill(Y, Row, RowCounts[static_cast<size_t>(Y)]);
				Texture.WriteRow(0, Y, Row);
			}
		});
	FNonFiniteSlots All;
	for (const FNonFiniteSlots& Counts : RowCounts)
	{
		for (size_t Slot = 0; Slot < All.size(); ++Slot)
		{
			All[Slot].Add(Counts[Slot]);
		}
	}
	return All;
}

} // namespace Drydock
