// Source: drydock.
#include "Text/TextFormat.h"

#include <charconv>
#include <cstdio>

namespace Drydock
{

std::string Format(const char* Pattern, double Number)
{
	char Buffer[64];
	std::snprintf(Buffer, sizeof(Buffer), Pattern, Number);
	return Buffer;
}

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

std::string PadRight(const std::string& Text, size_t Width)
{
	return Text + std::string(Width > Text.size() ? Width - Text.size() : 0, ' ');
}

std::string PadLeft(const std::string& Text, size_t Width)
{
	return std::string(Width > Text.size() ? Width - Text.size() : 0, ' ') + Text;
}

} // namespace Drydock
