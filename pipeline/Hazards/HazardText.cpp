// Writes what a pass made of the hazards.
#include "Hazards/HazardCapture.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextTable.h"

#include <algorithm>

namespace Drydock
{

namespace
{

std::string FormatRange(const FHazardFinding& Finding)
{
	return Finding.Least <= Finding.Most ? fmt::format("{:.4g} .. {:.4g}", Finding.Least, Finding.Most)
										 : std::string("nothing finite");
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
			Writer.EndObject();
		});
	return Writer.GetText();
}

} // namespace Drydock
