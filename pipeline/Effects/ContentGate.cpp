// Takes decisions back or confines them to a part of the view.
#include "Effects/ContentGate.h"

#include "HAL/IConsoleManager.h"

namespace Drydock
{

bool HasNone(const std::optional<FIntRect>& Bounds)
{
	return Bounds && Bounds->Area() == 0;
}

void Skip(FEffectDecision& Effect, const std::string& Why)
{
	Effect.bActive = false;
	Effect.bNothingToDo = true;
	Effect.Reason = Why + "; settings call for it: " + Effect.Reason;
}

void Confine(const FViewContent& Content, const FIntRect& Bounds, const char* What, FEffectDecision& Effect)
{
	constexpr double LargestRegion = 0.75;
	const double Part = static_cast<double>(Bounds.Area()) / (static_cast<double>(Content.Size.X) * Content.Size.Y);
	if (Part > LargestRegion || IsComputePreferred())
	{
		return;
	}
	Effect.Region = Bounds;
	Effect.Reason += std::string("; ") + What + " in " + std::to_string(Bounds.Width()) + "x" +
					 std::to_string(Bounds.Height()) + " of " + std::to_string(Content.Size.X) + "x" +
					 std::to_string(Content.Size.Y) + " pixels";
}

bool IsComputePreferred()
{
	const IConsoleVariable* Compute =
		IConsoleManager::Get().FindConsoleVariable(TEXT("r.PostProcessing.PreferCompute"));
	return Compute != nullptr && Compute->GetInt() != 0;
}

} // namespace Drydock
