// Writes numbers as text and lines text up in columns.
#include "Text/TextFormat.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace Drydock
{

namespace
{

template<typename T>
std::string WriteShortest(T Number)
{
	char Buffer[64];
	return std::string(Buffer, std::to_chars(Buffer, Buffer + sizeof(Buffer), Number).ptr);
}

} // namespace

std::string NumberText(float Number)
{
	return WriteShortest(Number);
}

std::string NumberText(double Number)
{
	return WriteShortest(Number);
}

std::string MakeFileNamePart(const std::string& Text)
{
	std::string Part = Text;
	std::replace_if(
		Part.begin(), Part.end(),
		[](char Character)
		{ return !std::isalnum(static_cast<unsigned char>(Character)) && Character != '_' && Character != '-'; },
		'_');
	return Part;
}

std::string AlignColumns(const std::vector<std::vector<std::string>>& Rows,
	const std::function<bool(size_t Column)>& IsText, const std::string& Indent)
{
	std::vector<size_t> Widths(Rows[0].size(), 0);
	for (const std::vector<std::string>& Row : Rows)
	{
		for (size_t Column = 0; Column < Row.size(); ++Column)
		{
			Widths[Column] = std::max(Widths[Column], Row[Column].size());
		}
	}
	std::string Text;
	for (const std::vector<std::string>& Row : Rows)
	{
		std::string Line;
		for (size_t Column = 0; Column < Row.size(); ++Column)
		{
			const std::string Padding(Widths[Column] - Row[Column].size(), ' ');
			Line += (Column > 0 ? "  " : "") + (IsText(Column) ? Row[Column] + Padding : Padding + Row[Column]);
		}
		Text += Indent + Line.substr(0, Line.find_last_not_of(' ') + 1) + "\n";
	}
	return Text;
}

} // namespace Drydock
