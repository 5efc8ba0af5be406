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
};

class DRYDOCK_API FCheckCapture final : public IDispatchObserver
{
public:
	/** Passes: pattern, of a pass's name or its shader's. */
	explicit FCheckCapture(const FCheckSet& InChecks, std::string InPasses = "*");
	~FCheckCapture() override;

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;
	void AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** In the order of the passes: the first is the first cause. */
	const std::vector<FPassFinding>& GetFindings() const { return Findings; }
	/** A warning DD4010 for each. */
	std::vector<FDiagnostic> GetDiagnostics() const;

private:
	std::vector<std::array<int32_t, 3>> FindSuspects(
		const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) const;
	bool IsSuspect(const double (&Color)[4], ETexelStorage Storage) const;

	const FCheckSet Checks;
	const std::string Passes;
	std::unique_ptr<FSandbox> Before; // of a compute shader: what it writes as it was
	FDispatchShaders Shaders;
	std::vector<FPassFinding> Findings;
};

} // namespace Drydock
