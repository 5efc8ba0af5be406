// The filters of BlurLanes.h for one lane width. Included by BlurLanes_*.cpp only.
#pragma once

#include "LanesTypes.h"
#include "Study/BlurLanes.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** A texel of N lines: four channels each. */
template<int N>
struct TLineTexel
{
	using FVector = TRaw<float, N>;

	FVector A, B, C, D;

	static DRYDOCK_LANES_INLINE TLineTexel Load(const float* P)
	{
		TLineTexel Texel;
		__builtin_memcpy(&Texel, __builtin_assume_aligned(P, sizeof(FVector)), sizeof(Texel));
		return Texel;
	}
	DRYDOCK_LANES_INLINE void Store(float* P) const
	{
		__builtin_memcpy(__builtin_assume_aligned(P, sizeof(FVector)), this, sizeof(*this));
	}

	friend DRYDOCK_LANES_INLINE TLineTexel operator+(const TLineTexel& X, const TLineTexel& Y)
	{
		return {X.A + Y.A, X.B + Y.B, X.C + Y.C, X.D + Y.D};
	}
	friend DRYDOCK_LANES_INLINE TLineTexel operator-(const TLineTexel& X, const TLineTexel& Y)
	{
		return {X.A - Y.A, X.B - Y.B, X.C - Y.C, X.D - Y.D};
	}
	friend DRYDOCK_LANES_INLINE TLineTexel operator*(const TLineTexel& X, FVector Factor)
	{
		return {X.A * Factor, X.B * Factor, X.C * Factor, X.D * Factor};
	}
};

/** A sum whose rounding errors are carried along (Kahan): right to two units in the last place, however long it is. */
template<int N>
struct TLineSum
{
	TLineTexel<N> Sum = {};
	TLineTexel<N> TooMuch = {};

	DRYDOCK_LANES_INLINE void Add(const TLineTexel<N>& Texel)
	{
		const TLineTexel<N> Wanted = Texel - TooMuch;
		const TLineTexel<N> Next = Sum + Wanted;
		TooMuch = (Next - Sum) - Wanted;
		Sum = Next;
	}
};

template<int N>
struct TLineFilter
{
	using FTexel = TLineTexel<N>;

	static constexpr size_t TexelFloats = 4 * N;
	static constexpr int32_t TexelsOfLine = 4; // 64 bytes of a row

	/** Calls Copy(in the picture, in the lanes) for every texel; lanes without a line take the last line. */
	template<typename F>
	static DRYDOCK_LANES_INLINE void ForEachTexel(const FBlurLines& Lines, int32_t NumLanes, float* Texels, F Copy)
	{
		for (int32_t First = 0; First < Lines.Length; First += TexelsOfLine)
		{
			const int32_t End = First + TexelsOfLine < Lines.Length ? First + TexelsOfLine : Lines.Length;
			for (int32_t Lane = 0; Lane < NumLanes; ++Lane)
			{
				const int32_t Line = Lane < Lines.NumLines ? Lane : Lines.NumLines - 1;
				float* InPicture = Lines.Data + static_cast<size_t>(Line) * Lines.LineStep;
				for (int32_t Texel = First; Texel < End; ++Texel)
				{
					Copy(InPicture + static_cast<size_t>(Texel) * Lines.TexelStep,
						Texels + static_cast<size_t>(Texel) * TexelFloats + static_cast<size_t>(Lane) * 4);
				}
			}
		}
	}
	static void Gather(const FBlurLines& Lines, float* Texels)
	{
		ForEachTexel(Lines, N, Texels,
			[](const float* InPicture, float* InLanes) { __builtin_memcpy(InLanes, InPicture, 4 * sizeof(float)); });
	}
	static void Scatter(const FBlurLines& Lines, float* Texels)
	{
		ForEachTexel(Lines, Lines.NumLines, Texels,
			[](float* InPicture, const float* InLanes) { __builtin_memcpy(InPicture, InLanes, 4 * sizeof(float)); });
	}

	/** Beyond the ends lies the end's texel. A window reaches over one border of blocks as long as itself: it is the
	 * sum from its first texel to that border and from there to its last, so nothing is ever taken away again, and
	 * what is not finite stays in its windows. Sums: of a window's texels. */
	static void Average(const float* In, float* Out, int32_t Length, const FBlurBox& Box, float* Sums)
	{
		const int32_t Window = 2 * Box.Radius + 1;
		const typename FTexel::FVector EndWeight = Broadcast<float, N>(Box.EndWeight);
		const typename FTexel::FVector Scale = Broadcast<float, N>(Box.Scale);
		const auto At = [=](int32_t Index)
		{
			const int32_t Inside = Index < 0 ? 0 : Index < Length ? Index : Length - 1;
			return FTexel::Load(In + static_cast<size_t>(Inside) * TexelFloats);
		};
		for (int32_t First = 0; First < Length; First += Window)
		{
			const int32_t Begin = First - Box.Radius;
			const int32_t Num = Window < Length - First ? Window : Length - First;
			TLineSum<N> Left;
			for (int32_t Index = Window; Index-- > 0;)
			{
				Left.Add(At(Begin + Index));
				if (Index < Num)
				{
					Left.Sum.Store(Sums + static_cast<size_t>(Index) * TexelFloats);
				}
			}
			TLineSum<N> Right;
			for (int32_t Index = 0; Index < Num; ++Index)
			{
				const FTexel Whole = FTexel::Load(Sums + static_cast<size_t>(Index) * TexelFloats) + Right.Sum;
				const FTexel After = At(Begin + Window + Index);
				const FTexel Ends = At(Begin - 1 + Index) + After;
				((Whole + Ends * EndWeight) * Scale).Store(Out + static_cast<size_t>(First + Index) * TexelFloats);
				Right.Add(After);
			}
		}
	}
};

/** The sections' state, and their next step. */
template<int N>
struct TLineRecursion
{
	using FTexel = TLineTexel<N>;

	typename FTexel::FVector First;
	typename FTexel::FVector Second;
	typename FTexel::FVector Damping;
	FTexel Real = {};
	FTexel Pair = {};
	FTexel Step = {};

	explicit TLineRecursion(const FBlurRecursion& Recursion)
		: First(Broadcast<float, N>(Recursion.First))
		, Second(Broadcast<float, N>(Recursion.Second))
		, Damping(Broadcast<float, N>(Recursion.Damping))
	{
	}

	DRYDOCK_LANES_INLINE void Filter(float* Texel)
	{
		Real = Real + (FTexel::Load(Texel) - Real) * First;
		Step = Step + ((Real - Pair) * Second - Step * Damping);
		Pair = Pair + Step;
		Pair.Store(Texel);
	}

	/** From the end of the way there to the begin of the way back; End: the line's last texel. */
	DRYDOCK_LANES_INLINE void TurnBack(const FBlurRecursion& Recursion, const FTexel& End)
	{
		const FTexel RealOff = Real - End;
		const FTexel PairOff = Pair - End;
		const auto Beyond = [&](const float* Factors)
		{
			return RealOff * Broadcast<float, N>(Factors[0]) + PairOff * Broadcast<float, N>(Factors[1]) +
				   Step * Broadcast<float, N>(Factors[2]);
		};
		Real = End + Beyond(Recursion.Turn[0]);
		Pair = End + Beyond(Recursion.Turn[1]);
		Step = Beyond(Recursion.Turn[2]);
	}
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes

namespace Drydock
{

template<int N>
void TBlurLanes<N>::AverageThrice(const FBlurLines& Lines, const FBlurBox& Box, float* Scratch)
{
	using FFilter = Lanes::TLineFilter<N>;
	const size_t NumFloats = static_cast<size_t>(Lines.Length) * FFilter::TexelFloats;
	float* Other = Scratch + NumFloats;
	float* Sums = Other + NumFloats;
	FFilter::Gather(Lines, Scratch);
	FFilter::Average(Scratch, Other, Lines.Length, Box, Sums);
	FFilter::Average(Other, Scratch, Lines.Length, Box, Sums);
	FFilter::Average(Scratch, Other, Lines.Length, Box, Sums);
	FFilter::Scatter(Lines, Other);
}

template<int N>
void TBlurLanes<N>::Recurse(const FBlurLines& Lines, const FBlurRecursion& Recursion, float* Scratch)
{
	using FFilter = Lanes::TLineFilter<N>;
	const size_t Length = static_cast<size_t>(Lines.Length);
	FFilter::Gather(Lines, Scratch);
	Lanes::TLineRecursion<N> State(Recursion);
	const auto End = FFilter::FTexel::Load(Scratch + (Length - 1) * FFilter::TexelFloats);
	State.Real = State.Pair = FFilter::FTexel::Load(Scratch); // as if the first texel had come for ever
	for (size_t Index = 0; Index < Length; ++Index)
	{
		State.Filter(Scratch + Index * FFilter::TexelFloats);
	}
	State.TurnBack(Recursion, End);
	for (size_t Index = Length; Index-- > 0;)
	{
		State.Filter(Scratch + Index * FFilter::TexelFloats);
	}
	FFilter::Scatter(Lines, Scratch);
}

} // namespace Drydock
