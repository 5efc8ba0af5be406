// Runs passes a second time by the interpreter, each before its kernel does.
#include "Inspect/LineCapture.h"

#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"

namespace Drydock
{

FLineCapture::FLineCapture(FLineRequest InRequest)
	: Request(std::move(InRequest))
	, Kernels(true)
	, bFound(Request.Show.size())
	, Problems(Request.Show.size())
{
}

FLineCapture::~FLineCapture() = default;

void FLineCapture::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Tile)
{
	if (!IsPassNamed(Request.Passes, Shader))
	{
		return;
	}
	const std::string Pass = GetPassName(Shader);
	for (size_t i = 0; !Request.Show.empty() && i < Whole.Get(Shader)->GetModule().Files.size(); ++i)
	{
		const std::string& File = Whole.Get(Shader)->GetModule().Files[i];
		Files.insert(File.ends_with(".usf") ? File.substr(File.rfind('/') + 1) : std::string());
	}
	for (size_t Index = 0; Index < Request.Show.size(); ++Index)
	{
		std::string Problem;
		std::optional<FLineValues> Values =
			CollectLineValues(*Whole.Get(Shader), Shader, Args, Tile, Request.Show[Index], Problem);
		if (Values)
		{
			bFound[Index] = true;
			Shown.push_back({Pass, Shader.Name, Request.Show[Index].Line, std::move(*Values)});
		}
		else if (!Problem.empty())
		{
			Problems[Index] = Problem; // of a shader that has the file
		}
	}
	if (Request.bCoverage)
	{
		AddCoverage(Coverage, CollectLineCoverage(*Whole.Get(Shader), Shader, Args, Tile));
	}
	if (Request.bRanges)
	{
		constexpr size_t Most = 32768;
		const auto Threads = Request.bAllThreads ? std::vector<std::array<int32_t, 3>>()
												 : SampleThreads(Tile, Shader.GetReflection(), Most);
		Ranges.push_back({Pass, Shader.Name, CollectLineRanges(*Whole.Get(Shader), Shader, Args, Tile, Threads)});
	}
	if (Request.bCost)
	{
		Costs.push_back({Pass, Shader.Name, MakeCostMap(*Kernels.Get(Shader), Shader, Args, Tile)});
	}
}

std::string FLineCapture::DescribeAbsence(size_t Index) const
{
	if (!Problems[Index].empty())
	{
		return Problems[Index];
	}
	std::string Names;
	for (const std::string& File : Files)
	{
		Names += File.empty() ? std::string() : (Names.empty() ? "" : ", ") + File;
	}
	return Names.empty() ? "no pass ran that matches '" + Request.Passes + "'"
						 : "no pass is made of " + Request.Show[Index].File + "; those that ran are made of " + Names;
}

const std::vector<FShownLine>& FLineCapture::GetShown() const
{
	std::vector<FDiagnostic> Missing;
	for (size_t Index = 0; Index < Request.Show.size(); ++Index)
	{
		if (!bFound[Index])
		{
			Missing.push_back({.Code = ErrorBadArgument, .Message = DescribeAbsence(Index), .Where = "--show"});
		}
	}
	if (!Missing.empty())
	{
		throw FError(std::move(Missing), ExitUsage);
	}
	return Shown;
}

std::string MakeCoverageText(const FLineCoverage& Coverage)
{
	std::string Text;
	for (const auto& [File, Lines] : Coverage.Files)
	{
		uint64_t Most = 1;
		for (const auto& [Line, Count] : Lines)
		{
			Most = std::max(Most, Count.Threads);
		}
		Text += (Text.empty() ? "" : "\n") + File + "\n";
		for (const auto& [Line, Count] : Lines)
		{
			const std::string Share =
				Count.Threads ? fmt::format("{:5.1f} %", 100.0 * double(Count.Threads) / double(Most)) : "  never";
			Text += fmt::format("{:>12}  {}  {:>5} | {}\n", Count.Threads, Share, Line, Count.Source);
		}
	}
	return Text;
}

} // namespace Drydock
