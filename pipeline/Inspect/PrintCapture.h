// Captures what shaders print while a frame runs: `drydock run --print`.
#pragma once

#include "DispatchObserver.h"
#include "Inspect/DispatchShaders.h"
#include "PrintedLines.h"

#include <optional>

namespace Drydock
{

struct FPassPrints
{
	std::string Pass;
	std::string Shader;
	FPrintedLines Printed;
};

class DRYDOCK_API FPrintCapture final : public IDispatchObserver
{
public:
	/** At: the only thread that is heard; Passes: pattern, of a pass's name or its shader's. */
	FPrintCapture(std::optional<std::array<int32_t, 3>> InAt, std::string InPasses);
	~FPrintCapture() override;

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** Prints of the passes that print anything, in their order; all together at most MaxPrintedLines. */
	const std::vector<FPassPrints>& GetPrints() const { return Prints; }
	/** Whether a shader that ran has a print at all. */
	bool CanPrint() const { return bCanPrint; }

private:
	const std::optional<std::array<int32_t, 3>> At;
	const std::string Passes;
	FDispatchShaders Shaders;
	std::vector<FPassPrints> Prints;
	size_t NumLines = 0;
	bool bCanPrint = false;
};

/** "Tint (3, 4) Tint.usf:12: weight 0.5", a line each, and how many more there were. */
DRYDOCK_API std::string MakePrintText(const std::vector<FPassPrints>& Prints);

} // namespace Drydock
