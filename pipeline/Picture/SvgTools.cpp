// Writes SVG elements and the texts in them.
#include "Picture/SvgTools.h"

#include "Text/Fmt.inl"

#include <charconv>

namespace Drydock
{

namespace
{

/** The first colours are those that colour-blind readers tell apart too. */
const char* const LightStyle =
	"text{font:12px system-ui,-apple-system,'Segoe UI',Helvetica,Arial,sans-serif;fill:#1f2328}\n"
	".title{font-size:19px;font-weight:600}.name{font-size:13.5px;font-weight:600}.plain{font-weight:400}"
	".quiet{fill:#59636e}.tick,.label,.budgettext{font-size:11px}.strong{font-weight:600}\n"
	".end{text-anchor:end}.mid{text-anchor:middle}.page{fill:#ffffff}.plot{fill:#818b98;fill-opacity:.06}\n"
	".grid{stroke:#d1d9e0;stroke-width:.7}.mark{stroke:#818b98;stroke-dasharray:2 3;stroke-opacity:.6}"
	".leader{stroke:#818b98;stroke-width:.8}.budget{stroke:#cf222e;stroke-width:1.2;stroke-dasharray:6 4}"
	".budgettext{fill:#cf222e}.within{fill:#1a7f37;fill-opacity:.07}\n"
	".line{fill:none;stroke:currentColor;stroke-width:2;stroke-linejoin:round;stroke-linecap:round}"
	".front{color:#1f2328;stroke-width:1.6;stroke-opacity:.55}"
	".whisker{stroke:currentColor;stroke-width:1.4;stroke-opacity:.6}\n"
	".dot{fill:currentColor;stroke:#ffffff;stroke-width:1.2}.off{fill-opacity:.35}.own{fill:currentColor}"
	".pick{fill:none;stroke:#1a7f37;stroke-width:2.2}.now{fill:none;stroke:#1f2328;stroke-width:1.5;"
	"stroke-dasharray:3 2.4}stop{stop-color:currentColor}\n"
	".c0{color:#d9730d}.c1{color:#2f6fdb}.c2{color:#2a9d68}.c3{color:#a651b5}.c4{color:#b08d00}.c5{color:#1b97b0}"
	".c6{color:#c2335c}.c7{color:#6e7781}.c8{color:#5b4fc9}.c9{color:#7a8f1e}.ink{color:#1f2328}.red{color:#cf222e}"
	".green{color:#1a7f37}.blue{color:#0969da}.grey{color:#8c959f}\n";

const char* const DarkStyle =
	"@media (prefers-color-scheme:dark){text{fill:#e6edf3}.quiet{fill:#9198a1}.page{fill:#0d1117}"
	".grid{stroke:#30363d}.dot{stroke:#0d1117}.front,.ink{color:#e6edf3}.now{stroke:#e6edf3}.pick{stroke:#3fb950}"
	".budget{stroke:#ff7b72}.budgettext{fill:#ff7b72}.within{fill:#3fb950}\n"
	".c0{color:#f0883e}.c1{color:#58a6ff}.c2{color:#3fb950}.c3{color:#d2a8ff}.c4{color:#e3b341}.c5{color:#56d4dd}"
	".c6{color:#ff7b9c}.c7{color:#9198a1}.c8{color:#a5a0ff}.c9{color:#b9ce5a}.red{color:#ff7b72}"
	".green{color:#56d364}.blue{color:#79c0ff}}\n";

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

std::string BeginSvg(double Height, const std::string& Title)
{
	return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
					   "role=\"img\" aria-label=\"{2}\">\n<style>\n{3}{4}</style>\n"
					   "<rect width=\"{0}\" height=\"{1}\" rx=\"8\" class=\"page\"/>\n",
		Px(SvgPageWidth), Px(Height), EscapeXml(Title), LightStyle, DarkStyle);
}

} // namespace Drydock
