// The expectations, one function each.
#include "CheckPass.h"

#include "Cases.h"
#include "Runs.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace Stability
{

namespace
{

constexpr int NumColors = 3; // alpha is each pass's own affair

/** One run of a cell. */
struct FContext
{
	const FRun& Pass;
	const FCell& Cell;
	const std::vector<FTrial>& Trials;
	const FTrial& Trial;
};

std::string Say(const std::string& What, int X, int Y, double Value)
{
	std::ostringstream Text;
	Text << What << " at (" << X << ", " << Y << "): " << Value;
	return Text.str();
}

std::string Say(const std::string& What, double Value, double Limit)
{
	std::ostringstream Text;
	Text << What << ": " << Value << ", limit " << Limit;
	return Text.str();
}

/** The first texel that does not pass. */
template<typename TTest>
std::string ForAll(const FImage& Image, const std::string& What, TTest Test)
{
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			for (int Channel = 0; Channel < NumColors; ++Channel)
			{
				if (!Test(X, Y, Channel, Image.At(X, Y)[Channel]))
				{
					return Say(What, X, Y, Image.At(X, Y)[Channel]);
				}
			}
		}
	}
	return Image.Texels.empty() ? "no result" : "";
}

bool HaveSameBits(double A, double B)
{
	return std::memcmp(&A, &B, sizeof(A)) == 0 || (std::isnan(A) && std::isnan(B));
}

std::string CompareBits(const FImage& Image, const FImage& Other, const std::string& What)
{
	if (Image.Width != Other.Width || Image.Height != Other.Height)
	{
		return "another size";
	}
	return ForAll(Image, What,
		[&](int X, int Y, int Channel, double Value) { return HaveSameBits(Value, Other.At(X, Y)[Channel]); });
}

std::string CheckFinite(const FImage& Image)
{
	return ForAll(Image, "not finite", [](int, int, int, double Value) { return std::isfinite(Value); });
}

/** Whether a result's pixel looks at the bad one: the gap between what lies under it and the bad pixel. */
bool IsInFootprint(const FContext& Context, int X, int Y)
{
	const auto Gap = [&](int At, int Bad)
	{
		return std::max(At * Context.Pass.Shrink - (Bad + 1), Bad - (At + 1) * Context.Pass.Shrink);
	};
	const double Reach = std::max(Context.Pass.Reach, 1e-9); // touching is not looking
	return Gap(X, Context.Trial.Bad.X) < Reach - 1e-6 && Gap(Y, Context.Trial.Bad.Y) < Reach - 1e-6;
}

std::string CheckOutside(const FContext& Context, const FImage& Result)
{
	const FImage Clean = Context.Pass.Run(Context.Trial.Clean);
	bool bOutside = false;
	const std::string Found = ForAll(Result, "changed outside of the footprint",
		[&](int X, int Y, int Channel, double Value)
		{
			const bool bInside = IsInFootprint(Context, X, Y);
			bOutside = bOutside || !bInside;
			return bInside || HaveSameBits(Value, Clean.At(X, Y)[Channel]);
		});
	return bOutside ? Found : "the footprint covers the picture";
}

bool HasNonFinite(const FImage& Image)
{
	return !CheckFinite(Image).empty();
}

double LargestOf(const FImage& Image)
{
	double Largest = 0;
	for (const FTexel& Texel : Image.Texels)
	{
		for (int Channel = 0; Channel < NumColors; ++Channel)
		{
			Largest = std::max(Largest, std::abs(Texel[Channel]));
		}
	}
	return Largest;
}

/** Largest difference; NaN and another size are infinite. */
double Distance(const FImage& A, const FImage& B)
{
	return PassReference::MaxDifference(A, B, NumColors);
}

std::string Limit(const std::string& What, double Value, double Most)
{
	return Value <= Most ? "" : Say(What, Value, Most);
}

FImage Run(const FContext& Context)
{
	return Context.Pass.Run(Context.Trial.Case);
}

std::string CheckSpreads(const FContext& Context)
{
	const FImage Result = Run(Context);
	const std::string Outside = CheckOutside(Context, Result);
	return !Outside.empty() ? Outside : HasNonFinite(Result) ? "" : "nothing is left of it";
}

std::string CheckCleaned(const FContext& Context)
{
	const FImage Result = Run(Context);
	const std::string Found = CheckFinite(Result);
	return !Found.empty() ? Found : CheckOutside(Context, Result);
}

std::string CheckFloods(const FContext& Context)
{
	const FImage Result = Run(Context), Clean = Context.Pass.Run(Context.Trial.Clean);
	size_t NumChanged = 0;
	for (size_t Index = 0; Index < Result.Texels.size(); ++Index)
	{
		NumChanged += Result.Texels[Index] != Clean.Texels[Index] ? 1 : 0;
	}
	const double Share = static_cast<double>(NumChanged) / static_cast<double>(Result.Texels.size());
	const std::string Found = CheckFinite(Result);
	return !Found.empty()                                  ? Found
		   : std::abs(Share - Context.Cell.Bound) <= 0.005 ? ""
														   : Say("share of the picture", Share, Context.Cell.Bound);
}

std::string CheckReadsAs(const FContext& Context)
{
	FCase Replaced = Context.Trial.Case;
	const double Value = Context.Cell.Bound;
	Replaced.Image.At(Context.Trial.Bad.X, Context.Trial.Bad.Y) = {Value, Value, Value, 1};
	const FImage Result = Run(Context);
	const std::string Found = CheckFinite(Result);
	return !Found.empty() ? Found : CompareBits(Result, Context.Pass.Run(Replaced), "other than with that value");
}

std::string CheckAsBlack(const FContext& Context)
{
	FCase BlackCase = Context.Trial.Case;
	const FImage& Image = Context.Trial.Case.Image;
	BlackCase.Image = FImage(Image.Width, Image.Height, {0, 0, 0, 1});
	const double Most = Context.Cell.Bound + 2 * Context.Pass.Gain * (Context.Cell.Bound == 0 ? LargestOf(Image) : 0.0);
	return Limit("away from black", Distance(Run(Context), Context.Pass.Run(BlackCase)), Most);
}

std::string CheckMirrored(const FContext& Context)
{
	FCase Negated = Context.Trial.Case;
	for (FTexel& Texel : Negated.Image.Texels)
	{
		for (int Channel = 0; Channel < NumColors; ++Channel)
		{
			Texel[Channel] = -Texel[Channel];
		}
	}
	const FImage Result = Context.Pass.Run(Negated);
	return ForAll(Run(Context), "not the negative of the negative's",
		[&](int X, int Y, int Channel, double Value) { return Value == -Result.At(X, Y)[Channel]; });
}

/** bFades: down to 0. */
std::string CheckBounded(const FContext& Context, bool bFades)
{
	double Least = 1e300, Most = -1e300;
	for (const FTexel& Texel : Context.Trial.Case.Image.Texels)
	{
		for (int Channel = 0; Channel < NumColors; ++Channel)
		{
			Least = std::min(Least, Texel[Channel]);
			Most = std::max(Most, Texel[Channel]);
		}
	}
	const double Slack = Context.Cell.Bound * std::max(std::abs(Least), std::abs(Most));
	const double Low = (bFades ? 0.0 : std::min(Least, Least * Context.Pass.Gain)) - Slack,
				 High = Most * Context.Pass.Gain + Slack;
	return ForAll(Run(Context), "outside of the input's range",
		[=](int, int, int, double Value) { return Value >= Low && Value <= High; });
}

double SumOf(const FImage& Image)
{
	return PassReference::SumOf(Image, 0) + PassReference::SumOf(Image, 1) + PassReference::SumOf(Image, 2);
}

std::string CheckEnergy(const FContext& Context)
{
	const double In = SumOf(Context.Trial.Case.Image) * Context.Pass.Gain;
	const double Out = SumOf(Run(Context)) * Context.Pass.Shrink * Context.Pass.Shrink;
	return Limit("light lost or won", std::abs(Out / In - 1), Context.Cell.Bound);
}

/** Over all positions: the first trial speaks for them. */
std::string CheckSteady(const FContext& Context)
{
	if (&Context.Trial != &Context.Trials.front())
	{
		return "";
	}
	double Least = 1e300, Most = 0;
	for (const FTrial& Trial : Context.Trials)
	{
		const double Sum = SumOf(Context.Pass.Run(Trial.Case));
		Least = std::min(Least, Sum);
		Most = std::max(Most, Sum);
	}
	return Limit("light varies", Least > 0 ? Most / Least - 1 : 1e300, Context.Cell.Bound);
}

std::string CheckSmooth(const FContext& Context)
{
	if (&Context.Trial == &Context.Trials.front())
	{
		return "";
	}
	const FTrial& Before = *(&Context.Trial - 1);
	const double In = Distance(Before.Case.Image, Context.Trial.Case.Image);
	const double Out = Distance(Context.Pass.Run(Before.Case), Run(Context));
	return Limit("result's change over the input's", Out / In, Context.Cell.Bound);
}

std::string CheckKept(const FContext& Context, bool bOnlyInside)
{
	const FTexel Flat = Context.Trial.Case.Image.At(0, 0);
	const FImage Result = Run(Context);
	return ForAll(Result, "not the constant",
		[&](int X, int Y, int Channel, double Value)
		{
			const double Expected = Flat[Channel] * Context.Pass.Gain;
			const double Slack = Context.Cell.Bound * std::abs(Expected);
			const bool bInside = X == Result.Width / 2 && Y == Result.Height / 2;
			return Value <= Expected + Slack &&
				   (Value >= Expected - Slack || (bOnlyInside && !bInside && Value >= -Slack));
		});
}

std::string CheckCentred(const FContext& Context)
{
	const auto Measure = [](const FImage& Image)
	{
		double Sum = 0, AtX = 0, AtY = 0;
		for (int Y = 0; Y < Image.Height; ++Y)
		{
			for (int X = 0; X < Image.Width; ++X)
			{
				const double Value = Image.At(X, Y)[0];
				Sum += Value;
				AtX += Value * (X + 0.5) / Image.Width;
				AtY += Value * (Y + 0.5) / Image.Height;
			}
		}
		return std::pair(AtX / Sum, AtY / Sum);
	};
	const FImage& Image = Context.Trial.Case.Image;
	const auto [InX, InY] = Measure(Image);
	const auto [OutX, OutY] = Measure(Run(Context));
	const double Shift = std::max(std::abs(OutX - InX) * Image.Width, std::abs(OutY - InY) * Image.Height);
	return Limit("the centre moved, pixels", std::isnan(Shift) ? 1e300 : Shift, 0.02);
}

std::string CheckSameAsCropped(const FContext& Context)
{
	return CompareBits(Run(Context), Context.Pass.Run(Context.Trial.Clean), "other than in a texture of its own");
}

std::string CheckAffine(const FContext& Context)
{
	const auto RunWith = [&](double Intensity)
	{
		FCase Case = Context.Trial.Case;
		Case.Intensity = Intensity;
		return Context.Pass.Run(Case);
	};
	const double Factor = Context.Trial.Case.Intensity.value_or(1.0);
	const FImage None = RunWith(0.0), One = RunWith(1.0), Result = Run(Context);
	const double Scale = std::abs(Factor) * Distance(One, None);
	double Largest = Scale > 0 ? 0.0 : 1e300;
	for (size_t Index = 0; Index < Result.Texels.size(); ++Index)
	{
		for (int Channel = 0; Channel < NumColors; ++Channel)
		{
			const double Expected =
				None.Texels[Index][Channel] + Factor * (One.Texels[Index][Channel] - None.Texels[Index][Channel]);
			const double Off = std::abs(Result.Texels[Index][Channel] - Expected);
			Largest = Off <= Largest ? Largest : std::isnan(Off) ? 1e300 : Off;
		}
	}
	return Limit("not in proportion", Largest / std::max(Scale, 1e-300), Context.Cell.Bound);
}

std::string CheckFormula(const FContext& Context)
{
	if (Context.Pass.Formula == nullptr)
	{
		return "the row has no formula";
	}
	const FImage Expected = Context.Pass.Formula(Context.Trial.Case);
	return Limit("away from the formula", Distance(Run(Context), Expected) / std::max(1.0, LargestOf(Expected)),
		Context.Cell.Bound);
}

std::string CheckAccurate(const FContext& Context)
{
	FCase Exact = Context.Trial.Case;
	Exact.Arithmetic = EArithmetic::Double;
	const FImage Reference = Context.Pass.Run(Exact);
	return Limit("error", Distance(Run(Context), Reference) / LargestOf(Reference), Context.Cell.Bound);
}

std::string CheckOne(const FContext& Context)
{
	switch (Context.Cell.Expect)
	{
	case EExpect::DoesNotApply:
		return "";
	case EExpect::Spreads:
		return CheckSpreads(Context);
	case EExpect::SpreadsAnywhere:
		return HasNonFinite(Run(Context)) ? "" : "nothing is left of it";
	case EExpect::Cleaned:
		return CheckCleaned(Context);
	case EExpect::Contained:
		return CheckOutside(Context, Run(Context));
	case EExpect::Floods:
		return CheckFloods(Context);
	case EExpect::ReadsAs:
		return CheckReadsAs(Context);
	case EExpect::Ignored:
	case EExpect::AsInfinity:
		return CompareBits(Run(Context), Context.Pass.Run(Context.Trial.Clean), "other bits");
	case EExpect::AsBlack:
		return CheckAsBlack(Context);
	case EExpect::Mirrored:
		return CheckMirrored(Context);
	case EExpect::CutOff:
		return ForAll(Run(Context), "below 0 or not finite",
			[](int, int, int, double Value) { return Value >= 0 && std::isfinite(Value); });
	case EExpect::Bounded:
		return CheckBounded(Context, false);
	case EExpect::Fades:
		return CheckBounded(Context, true);
	case EExpect::UnitRange:
		return ForAll(Run(Context), "outside of 0..1",
			[&](int, int, int, double Value) { return Value >= 0 && Value <= 1 + Context.Cell.Bound; });
	case EExpect::Finite:
		return CheckFinite(Run(Context));
	case EExpect::Overflows:
	{
		const FImage Result = Run(Context);
		return HasNonFinite(Result)
				   ? ForAll(Result, "NaN", [](int, int, int, double Value) { return !std::isnan(Value); })
				   : "nothing overflows";
	}
	case EExpect::Energy:
		return CheckEnergy(Context);
	case EExpect::Steady:
		return CheckSteady(Context);
	case EExpect::Smooth:
		return CheckSmooth(Context);
	case EExpect::Kept:
		return CheckKept(Context, false);
	case EExpect::KeptInside:
		return CheckKept(Context, true);
	case EExpect::Flat:
	{
		const FImage Result = Run(Context);
		return ForAll(Result, "not as the first pixel",
			[&](int, int, int Channel, double Value) { return Value == Result.At(0, 0)[Channel]; });
	}
	case EExpect::Centred:
		return CheckCentred(Context);
	case EExpect::SameAsCropped:
		return CheckSameAsCropped(Context);
	case EExpect::Identity:
		return CompareBits(Run(Context), Context.Trial.Case.Image, "other than the input");
	case EExpect::Zero:
		return ForAll(
			Run(Context), "not 0", [&](int, int, int, double Value) { return std::abs(Value) <= Context.Cell.Bound; });
	case EExpect::Affine:
		return CheckAffine(Context);
	case EExpect::Formula:
	case EExpect::Settles:
		return CheckFormula(Context);
	case EExpect::Accurate:
		return CheckAccurate(Context);
	default:
		return "not an expectation of a pass";
	}
}

} // namespace

std::string CheckPass(const FRow& Row, EHazard Hazard)
{
	const FRun& Pass = GetRuns().at(Row.Name);
	for (int Variant = 0; Variant < Pass.NumVariants; ++Variant)
	{
		const std::vector<FTrial> Trials = MakeTrials(Hazard, Variant);
		const FCell& Cell = Row.Cells[Hazard];
		if (Trials.empty() && Cell.Expect != EExpect::DoesNotApply)
		{
			return "the hazard has no case of a picture";
		}
		for (size_t Index = 0; Index < Trials.size() && Cell.Expect != EExpect::DoesNotApply; ++Index)
		{
			const std::string Found = CheckOne({Pass, Cell, Trials, Trials[Index]});
			if (!Found.empty())
			{
				return "form " + std::to_string(Variant) + ", run " + std::to_string(Index) + ": " + Found;
			}
		}
	}
	return "";
}

} // namespace Stability
