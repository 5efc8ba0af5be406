// Finds the writer of the frame's output: the last enabled pass of a sequence, or the last of its callbacks. Passes are
// declared once (SetEnabled), the sequence is closed (Finalize), and each pass asks in order whether the output is its
// own. Source: engine file OverridePassSequence.h.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

#include <array>
#include <optional>

template<typename EPass>
class TOverridePassSequence
{
	static constexpr size_t NumPasses = static_cast<size_t>(EPass::MAX);

public:
	explicit TOverridePassSequence(const FScreenPassRenderTarget& InOverrideOutput)
		: OverrideOutput(InOverrideOutput)
	{
	}

	/** Each pass exactly once, before Finalize. */
	void SetEnabled(EPass Pass, bool bEnabled)
	{
		FPassInfo& Info = At(Pass);
		checkf(!bFinalized && !Info.bAssigned, TEXT("Pass %d is assigned twice, or after Finalize"), int32(Pass));
		Info.bEnabled = bEnabled;
		Info.bAssigned = true;
	}

	bool IsEnabled(EPass Pass) const
	{
		checkf(At(Pass).bAssigned, TEXT("Pass %d is not assigned"), int32(Pass));
		return At(Pass).bEnabled;
	}

	/** Callbacks that will run after a pass. Any time before the pass accepts. */
	void SetNumCallbacks(EPass Pass, int32 NumCallbacks) { At(Pass).NumCallbacks = NumCallbacks; }

	/** Finds the last enabled pass. All must be assigned. */
	void Finalize()
	{
		check(!bFinalized);
		bFinalized = true;
		for (size_t Index = 0; Index < NumPasses; ++Index)
		{
			checkf(Passes[Index].bAssigned, TEXT("Pass %d is not assigned"), int32(Index));
			LastPass = Passes[Index].bEnabled ? std::optional(static_cast<EPass>(Index)) : LastPass;
		}
	}

	/** Empty: no pass is enabled. */
	std::optional<EPass> GetLastPass() const
	{
		check(bFinalized);
		return LastPass;
	}
	bool IsLastPass(EPass Pass) const { return GetLastPass() == Pass; }

	/** True for passes that come after the one that writes the output: what they make is not seen. */
	bool IsAfterLastPass(EPass Pass) const { return !GetLastPass() || Pass > *GetLastPass(); }

	/** Gives the output to the pass itself (no index) or to its callback of that index, if it is the last to run.
	 * Passes ask in order; a callback asks after its pass. */
	bool AcceptOverrideIfLastPass(
		EPass Pass, FScreenPassRenderTarget& OutTarget, std::optional<int32> CallbackIndex = {})
	{
		check(bFinalized);
		checkf(!NextPass || Pass >= *NextPass, TEXT("Pass %d accepts out of order"), int32(Pass));
		NextPass = Pass;
		const int32 NumCallbacks = At(Pass).NumCallbacks;
		const bool bLastToRun = CallbackIndex ? *CallbackIndex == NumCallbacks - 1 : NumCallbacks == 0;
		if (!IsLastPass(Pass) || !bLastToRun)
		{
			return false;
		}
		OutTarget = OverrideOutput;
		return true;
	}

private:
	struct FPassInfo
	{
		bool bEnabled = false;
		bool bAssigned = false;
		int32 NumCallbacks = 0;
	};

	FPassInfo& At(EPass Pass) { return Passes[static_cast<size_t>(Pass)]; }
	const FPassInfo& At(EPass Pass) const { return Passes[static_cast<size_t>(Pass)]; }

	FScreenPassRenderTarget OverrideOutput;
	std::array<FPassInfo, NumPasses> Passes;
	std::optional<EPass> LastPass;
	std::optional<EPass> NextPass;
	bool bFinalized = false;
};
