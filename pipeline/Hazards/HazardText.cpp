// Writes what a pass made of the hazards.
#include "Hazards/HazardCapture.h"
#include "Picture/Srgb.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextTable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Drydock
{

namespace
{

std::string FormatRange(const FHazardFinding& Finding)
{
	return Finding.Least <= Finding.Most ? fmt::format("{:.4g} .. {:.4g}", Finding.Least, Finding.Most)
										 : std::string("nothing finite");
}

std::string FormatColor(const std::array<double, 3>& Color)
{
	return fmt::format("{:.4g} {:.4g} {:.4g}", Color[0], Color[1], Color[2]);
}

/** Describes the pixels that are not finite. */
std::string DescribeNonFinite(const FHazardFinding& Finding)
{
	const std::string What = Finding.NumNaN > 0 && Finding.NumInfinite > 0 ? "NaN and infinite"
							 : Finding.NumNaN > 0                          ? "NaN"
																		   : "infinite";
	const uint64_t Count = std::max(Finding.NumNaN, Finding.NumInfinite);
	if (Count == Finding.NumPixels)
	{
		return "every pixel is " + What;
	}
	return fmt::format("{} of {} pixels {} {}", Count, Finding.NumPixels, Count == 1 ? "is" : "are", What);
}

} // namespace

std::string DescribeTone(const std::array<double, 3>& In, const std::array<double, 3>& Out)
{
	const auto Is = [&](const std::array<double, 3>& Wanted)
	{
		constexpr double Tolerance = 0.03; // a grade changes it a little
		return std::ranges::equal(
			Out, Wanted, [](double A, double B) { return std::abs(A - B) <= Tolerance * std::max(std::abs(B), 0.1); });
	};
	const auto Map = [&](double (*Function)(double))
	{
		return std::array<double, 3>{Function(In[0]), Function(In[1]), Function(In[2])};
	};
	const double Mean = (Out[0] + Out[1] + Out[2]) / 3;
	const auto Scaled = [&](double Factor)
	{
		return std::array<double, 3>{In[0] * Factor, In[1] * Factor, In[2] * Factor};
	};
	return Is(In)                      ? "as it was"
		   : Is(Map(EncodeSrgb))       ? "as sRGB encodes it: once more?"
		   : Is(Map(DecodeSrgb))       ? "as sRGB decodes it: once too often?"
		   : Is({In[2], In[1], In[0]}) ? "red and blue are swapped"
		   : Is({In[1], In[0], In[2]}) || Is({In[0], In[2], In[1]}) || Is({In[1], In[2], In[0]}) ||
				   Is({In[2], In[0], In[1]})
			   ? "channels are swapped"
		   : Is(Map([](double Value) { return Value * Value; }))   ? "squared: multiplied by itself?"
		   : In[0] != In[1] && Is({Mean, Mean, Mean})              ? "grey"
		   : In[0] != 0 && Mean != 0 && Is(Scaled(Out[0] / In[0])) ? fmt::format("times {:.3g}", Out[0] / In[0])
																   : "";
}

std::string DescribeFinding(const FHazardFinding& Finding)
{
	std::string Text;
	if (Finding.NumNaN + Finding.NumInfinite > 0)
	{
		Text = DescribeNonFinite(Finding);
	}
	else if (Finding.bAsInput)
	{
		Text = "finite: the bits of the input";
	}
	else
	{
		Text = Finding.bFlat ? "finite: one value everywhere" : "finite";
	}
	if (Finding.Reach >= 0)
	{
		Text += Finding.Reach == 0
					? "; stays where it is"
					: fmt::format("; {} pixels change, up to {} away", Finding.NumChanged, Finding.Reach);
	}
	if (Finding.NumNegative > 0)
	{
		Text += fmt::format("; {} pixels below 0", Finding.NumNegative);
	}
	return Text;
}

std::string MakeHazardText(const FHazardRow& Row, int Width)
{
	std::vector<std::vector<std::string>> Lines;
	for (const FHazardFinding& Finding : Row.Findings)
	{
		Lines.push_back({Finding.Hazard, FormatRange(Finding), DescribeFinding(Finding)});
	}
	for (const FHazardTone& Tone : Row.Tones)
	{
		const std::string Says = Tone.Says.empty() ? "" : ": " + Tone.Says;
		Lines.push_back({Tone.Name, FormatColor(Tone.In), "becomes " + FormatColor(Tone.Out) + Says});
	}
	return fmt::format(
			   "{}  ({}), hazards in place of {}, {} x {}\n", Row.Pass, Row.Shader, Row.Input, Row.Width, Row.Height) +
		   FTextTable{{{ETextColumn::Text}, {ETextColumn::Name}, {ETextColumn::Text}}, Lines}.Format(Width, "   ");
}

std::string MakeHazardJson(const std::vector<FHazardRow>& Rows)
{
	FJsonWriter Writer('{');
	Writer.Array("passes", Rows,
		[&](const FHazardRow& Row)
		{
			Writer.BeginObject();
			Writer.Members({{"pass", Row.Pass}, {"shader", Row.Shader}, {"input", Row.Input}});
			Writer.Array("hazards", Row.Findings,
				[&](const FHazardFinding& Finding)
				{
					Writer.Object({{"hazard", Finding.Hazard}, {"pixels", Finding.NumPixels}, {"nan", Finding.NumNaN},
						{"infinite", Finding.NumInfinite}, {"negative", Finding.NumNegative},
						{"changed", Finding.NumChanged}, {"reach", Finding.Reach}, {"least", Finding.Least},
						{"most", Finding.Most}, {"says", DescribeFinding(Finding)}});
				});
			Writer.Objects("tones", Row.Tones,
				[&](const FHazardTone& Tone) {
					Writer.Members({{"tone", Tone.Name}, {"in", Tone.In}, {"out", Tone.Out}, {"says", Tone.Says}});
				});
			Writer.EndObject();
		});
	return Writer.GetText();
}

bool MakesNaNOfFinite(const FHazardFinding& Finding)
{
	const bool bInfinite = std::ranges::any_of(std::array{"NaN", "+Inf", "-Inf", "65520", "1e30"},
		[&](const char* Name) { return Finding.Hazard.starts_with(Name); }); // as a half has it
	return !bInfinite && Finding.NumNaN > 0;
}

} // namespace Drydock
