// Draws the stability table.
#include "StabilityPicture.h"

#include "Table.h"

#include <sstream>
#include <vector>

namespace Stability
{

namespace
{

constexpr int Cell = 15;
constexpr int LabelWidth = 300;
constexpr int TitleHeight = 120;
constexpr int LegendHeight = 40;

struct FColor
{
	const char* Color;
	const char* Meaning;
};

constexpr FColor Stated = {"#4c9f70", "finite, and as stated"};
constexpr FColor Footprint = {"#e6c84f", "keeps to its footprint"};
constexpr FColor Share = {"#e08e45", "changes a stated share"};
constexpr FColor Spread = {"#c8504b", "spreads, or overflows"};
constexpr FColor Nothing = {"#e4e4e4", "does not apply"};

FColor GetColor(EExpect Expect)
{
	switch (Expect)
	{
	case EExpect::DoesNotApply:
		return Nothing;
	case EExpect::Spreads:
	case EExpect::Contained:
		return Footprint;
	case EExpect::Floods:
		return Share;
	case EExpect::SpreadsAnywhere:
	case EExpect::Overflows:
		return Spread;
	default:
		return Stated;
	}
}

/** Text of a label or tooltip. */
std::string Escape(std::string_view Text)
{
	std::string Escaped;
	for (const char Letter : Text)
	{
		Escaped += Letter == '<' ? "&lt;" : Letter == '>' ? "&gt;" : Letter == '&' ? "&amp;" : std::string(1, Letter);
	}
	return Escaped;
}

void DrawLegend(std::ostream& Svg, int Y)
{
	int X = 4 * Cell;
	for (const FColor& Color : {Stated, Footprint, Share, Spread, Nothing})
	{
		constexpr int LetterWidth = 6;
		Svg << "<rect x=\"" << X << "\" y=\"" << Y << "\" width=\"12\" height=\"12\" fill=\"" << Color.Color << "\"/>\n"
			<< "<text x=\"" << X + Cell + 2 << "\" y=\"" << Y + 10 << "\">" << Color.Meaning << "</text>\n";
		X += 2 * Cell + LetterWidth * static_cast<int>(std::string_view(Color.Meaning).size());
	}
}

} // namespace

std::string MakeStabilityPicture()
{
	std::vector<const FRow*> Rows = GetRows("pipeline/");
	for (const FRow* Pass : GetRows("passes/"))
	{
		Rows.push_back(Pass);
	}
	const int Width = LabelWidth + Cell * static_cast<int>(NumHazards) + 60;
	const int Height = TitleHeight + Cell * static_cast<int>(Rows.size()) + LegendHeight;
	std::ostringstream Svg;
	Svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << Width << "\" height=\"" << Height
		<< "\" font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
	for (size_t Hazard = 0; Hazard < NumHazards; ++Hazard)
	{
		const int X = LabelWidth + Cell * static_cast<int>(Hazard) + 11;
		Svg << "<text transform=\"translate(" << X << " " << TitleHeight - 6 << ") rotate(-60)\">"
			<< Escape(Hazards[Hazard].Title) << "</text>\n";
	}
	for (size_t Index = 0; Index < Rows.size(); ++Index)
	{
		const int Y = TitleHeight + Cell * static_cast<int>(Index);
		Svg << "<text x=\"" << LabelWidth - 6 << "\" y=\"" << Y + 11 << "\" text-anchor=\"end\">"
			<< Escape(Rows[Index]->Name) << "</text>\n";
		for (size_t Hazard = 0; Hazard < NumHazards; ++Hazard)
		{
			const FCell& Value = Rows[Index]->Cells[static_cast<EHazard>(Hazard)];
			Svg << "<rect x=\"" << LabelWidth + Cell * static_cast<int>(Hazard) << "\" y=\"" << Y
				<< "\" width=\"13\" height=\"13\" fill=\"" << GetColor(Value.Expect).Color << "\"><title>"
				<< Escape(Rows[Index]->Name) << ", " << Escape(Hazards[Hazard].Title) << ": " << Escape(Value.Reason)
				<< "</title></rect>\n";
		}
	}
	DrawLegend(Svg, Height - LegendHeight + 16);
	Svg << "</svg>\n";
	return Svg.str();
}

} // namespace Stability
