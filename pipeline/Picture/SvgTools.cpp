// Writes SVG elements and the texts in them.
#include "Picture/SvgTools.h"

#include "Text/Fmt.inl"

#include <charconv>

namespace Drydock
{

namespace
{

constexpr const char* SvgStyle =
#include "SvgStyle.txt"
	;

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
		Escaped += Character == '&'   ? "&amp;"
				   : Character == '<' ? "&lt;"
				   : Character == '>' ? "&gt;"
				   : Character == '"' ? "&quot;"
									  : std::string(1, static_cast<unsigned char>(Character) < 0x20 ? ' ' : Character);
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

std::string BeginSvg(double Height, const std::string& Title)
{
	return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
					   "role=\"img\" aria-label=\"{2}\">\n<style>\n{3}</style>\n"
					   "<rect width=\"{0}\" height=\"{1}\" rx=\"8\" class=\"page\"/>\n",
		Px(SvgPageWidth), Px(Height), EscapeXml(Title), SvgStyle);
}

} // namespace Drydock
