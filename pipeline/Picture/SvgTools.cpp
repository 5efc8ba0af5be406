// Writes SVG elements and the texts in them.
#include "Picture/SvgTools.h"

#include "Math/ToInteger.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace Drydock
{

namespace
{

const char* const LightStyle =
	"text{font:12px system-ui,-apple-system,'Segoe UI',Helvetica,Arial,sans-serif;fill:#1f2328}\n";

const char* const DarkStyle = "@media (prefers-color-scheme:dark){text{fill:#e6edf3}.quiet{fill:#9198a1}"
							  ".page{fill:#0d1117}.grid{stroke:#30363d}.dot{stroke:#0d1117}";

} // namespace

std::string FixedText(double Number, int Digits)
{
	char Buffer[400];
	const std::to_chars_result Result =
		std::to_chars(Buffer, Buffer + sizeof(Buffer), Number, std::chars_format::fixed, Digits);
	std::string Text(Buffer, Result.ptr);
	if (Text.find('.') != std::string::npos)
	{
		Text.erase(Text.find_last_not_of('0') + 1);
		Text.erase(Text.find_last_not_of('.') + 1);
	}
	return Text == "-0" ? "0" : Text;
}

std::string Px(double Number)
{
	return FixedText(Number, 2);
}

std::string ShortText(double Number)
{
	char Buffer[32];
	return std::string(
		Buffer, std::to_chars(Buffer, Buffer + sizeof(Buffer), Number, std::chars_format::general, 4).ptr);
}

std::string EscapeXml(const std::string& Text)
{
	std::string Escaped;
	for (const char Character : Text)
	{
		switch (Character)
		{
		case '&':
			Escaped += "&amp;";
			break;
		case '<':
			Escaped += "&lt;";
			break;
		case '>':
			Escaped += "&gt;";
			break;
		case '"':
			Escaped += "&quot;";
			break;
		default:
			Escaped += static_cast<unsigned char>(Character) < 0x20 ? ' ' : Character;
		}
	}
	return Escaped;
}

std::string ShortenText(const std::string& Text, size_t MaxCharacters)
{
	size_t NumCharacters = 0;
	for (size_t Index = 0; Index < Text.size(); ++Index)
	{
		const bool bStart = (static_cast<unsigned char>(Text[Index]) & 0xC0) != 0x80;
		if (bStart && NumCharacters++ == MaxCharacters)
		{
			return Text.substr(0, Index) + "\xE2\x80\xA6";
		}
	}
	return Text;
}

std::string SvgText(double X, double Y, const std::string& Class, const std::string& Text)
{
	return SvgMarkup(X, Y, Class, EscapeXml(Text));
}

std::string SvgMarkup(double X, double Y, const std::string& Class, const std::string& Markup)
{
	const std::string Attribute = Class.empty() ? "" : " class=\"" + Class + "\"";
	return fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>\n", Px(X), Px(Y), Attribute, Markup);
}

std::string SvgLine(double X1, double Y1, double X2, double Y2, const std::string& Class)
{
	return fmt::format(
		"<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" class=\"{}\"/>\n", Px(X1), Px(Y1), Px(X2), Px(Y2), Class);
}

std::string SvgRect(const FSvgBox& Box, const std::string& Class)
{
	return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" class=\"{}\"/>\n", Px(Box.Left), Px(Box.Top),
		Px(Box.Right - Box.Left), Px(Box.Bottom - Box.Top), Class);
}

std::string SvgPathData(const std::vector<FSvgPoint>& Points)
{
	std::string Text;
	for (const FSvgPoint& Point : Points)
	{
		Text += fmt::format("{}{} {}", Text.empty() ? "M" : " L", Px(Point.first), Px(Point.second));
	}
	return Text;
}

std::string SvgPath(const std::vector<FSvgPoint>& Points, const std::string& Class)
{
	return "<path d=\"" + SvgPathData(Points) + "\" class=\"" + Class + "\"/>\n";
}

std::string BeginSvg(double Width, double Height, const std::string& Title, const char* Light, const char* Dark)
{
	return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
					   "role=\"img\" aria-label=\"{2}\">\n<style>\n{3}{4}{5}{6}}}\n</style>\n",
		Px(Width), Px(Height), EscapeXml(Title), LightStyle, Light, DarkStyle, Dark);
}

std::string SvgPage(double Width, double Height, double Radius)
{
	return fmt::format(
		"<rect width=\"{}\" height=\"{}\" rx=\"{}\" class=\"page\"/>\n", Px(Width), Px(Height), Px(Radius));
}

FAxisTicks::FAxisTicks(double Low, double High, int MaxTicks)
{
	const double Rough = (High - Low) / MaxTicks;
	const double Power = std::pow(10.0, std::floor(std::log10(Rough)));
	Step = Power;
	for (const double Factor : {2.0, 5.0, 10.0})
	{
		Step = Step < Rough ? Factor * Power : Step;
	}
	Digits = std::max(0, ToInteger<int>(-std::floor(std::log10(Step) + 1e-9)));
	// Counted: between two neighbouring numbers a step is too small to lead from one to the other.
	const double First = std::ceil(Low / Step - 1e-9);
	for (int Tick = 0; Tick <= 2 * MaxTicks && (First + Tick) * Step <= High + Step * 1e-9; ++Tick)
	{
		Values.push_back((First + Tick) * Step);
	}
}

std::vector<FSvgPoint> SimplifyCurve(const std::vector<FSvgPoint>& Points)
{
	std::vector<bool> Kept(Points.size(), false);
	std::vector<std::pair<size_t, size_t>> Open;
	if (!Points.empty())
	{
		Kept.front() = Kept.back() = true;
		Open.emplace_back(0, Points.size() - 1);
	}
	while (!Open.empty())
	{
		const auto [First, Last] = Open.back();
		Open.pop_back();
		double Worst = 0.02;
		size_t Farthest = First;
		for (size_t Index = First + 1; Index < Last; ++Index)
		{
			const double Span = Points[Last].first - Points[First].first;
			const double Part = Span > 0.0 ? (Points[Index].first - Points[First].first) / Span : 0.0;
			const double OnLine = Points[First].second + (Points[Last].second - Points[First].second) * Part;
			if (std::abs(Points[Index].second - OnLine) > Worst)
			{
				Worst = std::abs(Points[Index].second - OnLine);
				Farthest = Index;
			}
		}
		if (Farthest != First)
		{
			Kept[Farthest] = true;
			Open.emplace_back(First, Farthest);
			Open.emplace_back(Farthest, Last);
		}
	}
	std::vector<FSvgPoint> Result;
	for (size_t Index = 0; Index < Points.size(); ++Index)
	{
		if (Kept[Index])
		{
			Result.push_back(Points[Index]);
		}
	}
	return Result;
}

} // namespace Drydock
