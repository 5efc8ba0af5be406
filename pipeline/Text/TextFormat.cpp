// Writes numbers and lists as text, and text as parts of file names.
#include "Text/TextFormat.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>

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

std::string FormatCode(int Code)
{
	char Text[16];
	std::snprintf(Text, sizeof(Text), "DD%04d", Code);
	return Text;
}

} // namespace Drydock
