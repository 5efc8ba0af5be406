// Reads .cube files line by line, samples their tables, and writes them.
#include "Picture/ColorCube.h"

#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Drydock
{

namespace
{

constexpr int LegacySize = 16;

class FCubeReader
{
public:
	explicit FCubeReader(const std::string& InPath)
		: Path(InPath)
	{
	}

	FColorCube Read()
	{
		std::istringstream Text(ReadTextFile(Path, "the table cannot be read"));
		for (std::string Whole; std::getline(Text, Whole);)
		{
			++Line;
			TakeLine(Whole.substr(0, Whole.find_last_not_of(" \t\r") + 1));
		}
		const size_t Expected = GetNumColors();
		Require(Cube.Size > 0, "LUT_3D_SIZE is missing");
		Require(Cube.Colors.size() == Expected,
			fmt::format("a table of {0} x {0} x {0} has {1} colours, and the file has {2}", Cube.Size, Expected,
				Cube.Colors.size()));
		return Cube;
	}

private:
	void Require(bool bHolds, const std::string& Otherwise) const
	{
		if (!bHolds)
		{
			throw FError({.Code = ErrorColorCube, .Message = Otherwise, .File = Path, .Line = Line}, ExitFiles);
		}
	}

	size_t GetNumColors() const
	{
		const size_t Size = static_cast<size_t>(Cube.Size);
		return Size * Size * Size;
	}

	std::array<double, 3> ReadColor(const std::string& Text) const
	{
		std::array<double, 3> Color = {};
		std::istringstream Numbers(Text);
		std::string Rest;
		Numbers >> Color[0] >> Color[1] >> Color[2];
		Require(!Numbers.fail() && !(Numbers >> Rest) &&
					std::ranges::all_of(Color, [](double Value) { return std::isfinite(Value); }),
			"expected three numbers, found \"" + Text + "\"");
		return Color;
	}

	void TakeLine(const std::string& Text)
	{
		const std::string Word = Text.substr(0, Text.find_first_of(" \t"));
		const std::string Rest = Text.substr(std::min(Text.size(), Word.size() + 1));
		if (Text.empty() || Text[0] == '#' || Word == "TITLE")
		{
			return;
		}
		if (Word == "LUT_3D_SIZE")
		{
			Cube.Size = std::atoi(Rest.c_str());
			Require(Cube.Size >= 2 && Cube.Size <= 256, "LUT_3D_SIZE must be 2 to 256, but is " + Rest);
		}
		else if (Word == "DOMAIN_MIN" || Word == "DOMAIN_MAX")
		{
			(Word == "DOMAIN_MIN" ? Cube.DomainMin : Cube.DomainMax) = ReadColor(Rest);
		}
		else
		{
			Require(Word != "LUT_1D_SIZE",
				"the table has one dimension (LUT_1D_SIZE); ColorGradingLUT needs three (LUT_3D_SIZE)");
			Require(Cube.Colors.size() < GetNumColors(),
				"a line that is not known, or a colour too many: \"" + Text + "\"");
			Cube.Colors.push_back(ReadColor(Text));
		}
	}

	const std::string Path;
	FColorCube Cube;
	int Line = 0;
};

} // namespace

std::array<double, 3> FColorCube::Sample(const std::array<double, 3>& Color) const
{
	std::array<size_t, 3> First = {};
	std::array<double, 3> Part = {};
	for (size_t Axis = 0; Axis < 3; ++Axis)
	{
		const double Scaled = (Color[Axis] - DomainMin[Axis]) / (DomainMax[Axis] - DomainMin[Axis]) * (Size - 1);
		const double Place = std::clamp(Scaled, 0.0, static_cast<double>(Size - 1));
		First[Axis] = static_cast<size_t>(std::min(Place, static_cast<double>(Size - 2)));
		Part[Axis] = Place - static_cast<double>(First[Axis]);
	}
	std::array<double, 3> Sum = {};
	for (size_t Corner = 0; Corner < 8; ++Corner)
	{
		double Weight = 1.0;
		size_t Index = 0;
		for (size_t Axis = 3; Axis-- > 0;)
		{
			const size_t Step = Corner >> Axis & 1;
			Weight *= Step == 1 ? Part[Axis] : 1.0 - Part[Axis];
			Index = Index * static_cast<size_t>(Size) + First[Axis] + Step;
		}
		for (size_t Channel = 0; Channel < 3 && Weight > 0.0; ++Channel)
		{
			Sum[Channel] += Weight * Colors[Index][Channel];
		}
	}
	return Sum;
}

bool IsColorCubePath(const std::string& Path)
{
	return ToLowerCase(Path).ends_with(".cube");
}

FColorCube ReadColorCube(const std::string& Path)
{
	return FCubeReader(Path).Read();
}

FImage MakeLegacyTable(const FColorCube& Cube)
{
	FImage Table{LegacySize * LegacySize, LegacySize, 3, {}};
	for (int Pixel = 0; Pixel < Table.Width * Table.Height; ++Pixel)
	{
		const int X = Pixel % Table.Width;
		const std::array<double, 3> Place = {static_cast<double>(X % LegacySize),
			static_cast<double>(Pixel / Table.Width), static_cast<double>(X / LegacySize)};
		const size_t Index = static_cast<size_t>((Place[2] * LegacySize + Place[1]) * LegacySize + Place[0]);
		const bool bWhole = Cube.Size == LegacySize && Cube.DomainMin == FColorCube().DomainMin &&
							Cube.DomainMax == FColorCube().DomainMax;
		const std::array<double, 3> Color =
			bWhole
				? Cube.Colors[Index]
				: Cube.Sample({Place[0] / (LegacySize - 1), Place[1] / (LegacySize - 1), Place[2] / (LegacySize - 1)});
		Table.Values.insert(Table.Values.end(), Color.begin(), Color.end());
	}
	return Table;
}

std::string MakeColorCubeText(
	const FColorCube& Cube, const std::string& Title, const std::vector<std::string>& Comments)
{
	std::string Text;
	for (const std::string& Comment : Comments)
	{
		Text += "# " + Comment + "\n";
	}
	Text += fmt::format("TITLE \"{}\"\nLUT_3D_SIZE {}\nDOMAIN_MIN {:g} {:g} {:g}\nDOMAIN_MAX {:g} {:g} {:g}\n", Title,
		Cube.Size, Cube.DomainMin[0], Cube.DomainMin[1], Cube.DomainMin[2], Cube.DomainMax[0], Cube.DomainMax[1],
		Cube.DomainMax[2]);
	for (const std::array<double, 3>& Color : Cube.Colors)
	{
		Text += fmt::format("{:.7g} {:.7g} {:.7g}\n", Color[0], Color[1], Color[2]);
	}
	return Text;
}

} // namespace Drydock
