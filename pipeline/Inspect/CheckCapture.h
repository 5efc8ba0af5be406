// Finds faults of a run's shaders while the frame runs: `drydock run --check`.
#pragma once

#include "CoreMinimal.h"
#include "Diagnostics.h"
#include "DispatchObserver.h"
#include "Inspect/DispatchShaders.h"
#include "KernelCheck.h"

#include <memory>

namespace Drydock
{

/** "nan", "overflow", "negative", "denormal", "bounds", "uninit", "overlap", "assert", "race", or "all". Throws FError
 * (DD1020) for other names. */
DRYDOCK_API FCheckSet MakeCheckSet(const std::vector<std::string>& Names);
DRYDOCK_API std::vector<std::string> GetCheckNames();

/** A finding and the pass that it is of. */
struct FPassFinding
{
	std::string Pass;
	std::string Shader;
	FCheckFinding Finding;
	FIntPoint Size = FIntPoint(0, 0); // of what the threads' numbers count in
	bool bForeign = false;            // a plugin's pass
	uint64_t Looked = 0;              // threads that were looked at
	uint64_t Total = 0;               // and all
};

/** The passes and threads that are looked at. */
struct FCheckScope
{
	std::string Passes = "*"; // pattern, of a pass's name or its shader's
	bool bAllThreads = true;  // else of a plugin's pass 32768, of another 4096
	bool bHidden = false;     // NaN is also looked for where the stored texel is finite: a clamp may hide it
	bool bStated = true;      // findings that StatedFindings.h lists are reported too
};

class DRYDOCK_API FCheckCapture final : public IDispatchObserver
{
public:
	explicit FCheckCapture(const FCheckSet& InChecks, FCheckScope InScope = {});
	~FCheckCapture() override;

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;
	void AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** In the order of the passes: the first is the first cause. */
	const std::vector<FPassFinding>& GetFindings() const { return Findings; }
	/** A warning DD4010 for each; those of plugins' passes first. */
	std::vector<FDiagnostic> GetDiagnostics() const;

private:
	std::vector<std::array<int32_t, 3>> FindSuspects(
		const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) const;
	bool IsStated(const FCheckFinding& Finding) const;
	bool IsSuspect(const double (&Color)[4], ETexelStorage Storage) const;

	const FCheckSet Checks;
	const FCheckScope Scope;
	std::unique_ptr<FSandbox> Before; // of a compute shader: what it writes as it was
	FDispatchShaders Shaders;
	std::vector<FPassFinding> Findings;
};

} // namespace Drydock
