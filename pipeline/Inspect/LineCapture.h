// Collects the values of shader lines over a whole frame, while it runs: values as pictures, coverage, cost.
#pragma once

#include "CostMap.h"
#include "Diagnostics.h"
#include "DispatchObserver.h"
#include "Inspect/DispatchShaders.h"
#include "LineCoverage.h"
#include "LineValues.h"

#include <set>

namespace Drydock
{

struct FLineRequest
{
	std::vector<FLinePlace> Show;
	bool bCoverage = false;
	bool bCost = false;
	bool bRanges = false;
	bool bAllThreads = false; // for ranges; else at most 32768 of a pass
	std::string Passes = "*"; // pattern, of a pass's name or its shader's
};

struct FShownLine
{
	std::string Pass;
	std::string Shader;
	int Line = 0;
	FLineValues Values;
};

struct FPassRanges
{
	std::string Pass;
	std::string Shader;
	std::vector<FLineRange> Lines;
};

struct FPassCost
{
	std::string Pass;
	std::string Shader;
	FCostMap Map;
};

class DRYDOCK_API FLineCapture final : public IDispatchObserver
{
public:
	explicit FLineCapture(FLineRequest InRequest);
	~FLineCapture() override;

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** In the order of the passes. Throws FError (DD1020) with all places that no pass gave a value for. */
	const std::vector<FShownLine>& GetShown() const;
	const FLineCoverage& GetCoverage() const { return Coverage; }
	const std::vector<FPassCost>& GetCosts() const { return Costs; }
	const std::vector<FPassRanges>& GetRanges() const { return Ranges; }

private:
	std::string DescribeAbsence(size_t Index) const;

	const FLineRequest Request;
	FDispatchShaders Whole;   // with functions and variables
	FDispatchShaders Kernels; // as kernels are made of
	std::vector<FShownLine> Shown;
	std::vector<bool> bFound;          // by place of the request
	std::vector<std::string> Problems; // the same: why there is nothing
	std::set<std::string> Files;       // of shaders that ran
	FLineCoverage Coverage;
	std::vector<FPassCost> Costs;
	std::vector<FPassRanges> Ranges;
};

/** "/P/X.usf" with each of its lines that has instructions: how many threads ran it, their share, and the line. */
DRYDOCK_API std::string MakeCoverageText(const FLineCoverage& Coverage);

} // namespace Drydock
