// Runs the shaders that print a second time by the interpreter, each before its kernel does.
#include "Inspect/PrintCapture.h"

#include <algorithm>

namespace Drydock
{

FPrintCapture::FPrintCapture(std::optional<std::array<int32_t, 3>> InAt, std::string InPasses)
	: At(InAt)
	, Passes(std::move(InPasses))
{
}

FPrintCapture::~FPrintCapture() = default;

void FPrintCapture::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	if (!IsPassNamed(Passes, Shader))
	{
		return;
	}
	const std::shared_ptr<FInspectedShader> Inspected = Shaders.Get(Shader);
	if (!DoesPrint(*Inspected))
	{
		return;
	}
	bCanPrint = true;
	std::vector<std::array<int32_t, 3>> Threads;
	if (At)
	{
		const auto [X, Y, Z] = *At;
		const bool bInside =
			X >= Whole.MinX && Y >= Whole.MinY && Z >= Whole.MinZ && X < Whole.MaxX && Y < Whole.MaxY && Z < Whole.MaxZ;
		Threads.resize(bInside ? 1 : 0, *At);
	}
	else
	{
		Threads = ListThreads(Whole);
	}
	FPassPrints Print{GetPassName(Shader), Shader.Name, CollectPrints(*Inspected, Shader, Args, std::move(Threads))};
	std::vector<FPrintedLine>& Lines = Print.Printed.Lines;
	const size_t Kept = std::min(Lines.size(), MaxPrintedLines - NumLines);
	Print.Printed.NumMore += Lines.size() - Kept;
	Lines.resize(Kept);
	NumLines += Kept;
	if (!Lines.empty() || Print.Printed.NumMore)
	{
		Prints.push_back(std::move(Print));
	}
}

std::string MakePrintText(const std::vector<FPassPrints>& Prints)
{
	std::string Text;
	for (const FPassPrints& Print : Prints)
	{
		for (const FPrintedLine& Line : Print.Printed.Lines)
		{
			Text += Print.Pass + " (" + std::to_string(Line.At[0]) + ", " + std::to_string(Line.At[1]) +
					(Line.At[2] ? ", " + std::to_string(Line.At[2]) : std::string()) + ") " +
					Line.File.substr(Line.File.rfind('/') + 1) + ":" + std::to_string(Line.Line) + ": " + Line.Text +
					"\n";
		}
		if (Print.Printed.NumMore)
		{
			Text += Print.Pass + ": " + std::to_string(Print.Printed.NumMore) +
					" more lines; --print X,Y hears one pixel\n";
		}
	}
	return Text;
}

} // namespace Drydock
