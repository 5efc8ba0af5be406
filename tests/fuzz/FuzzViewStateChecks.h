// Checks any bytes in place of a frame's view_state.bin: they give a state that is written as the same bytes again, or
// one message. The fuzzer uses this, and a test that runs its corpus.
#pragma once

#include "Diagnostics.h"
#include "RenderGraphResourcePool.h"
#include "RenderTargetPool.h"
#include "Sequence/SequenceErrors.h"
#include "Sequence/ViewStateFile.h"
#include "Text/Fingerprint.h"

#include <algorithm>
#include <string>
#include <vector>

namespace Drydock
{

/** The bytes with the fingerprint that their reader asks for in place of the last ones: who forges a file knows it. */
inline std::string SealViewState(const std::string& Bytes)
{
	const std::string Body = Bytes.substr(0, Bytes.size() - std::min<size_t>(Bytes.size(), 32));
	FFingerprint Fingerprint;
	Fingerprint.Add(Body.data(), Body.size());
	return Body + Fingerprint.Get();
}

inline std::string CheckSealedViewState(const std::string& Bytes)
{
	try
	{
		const std::vector<FViewHistory> Views = UnpackViewStates(Bytes, "view_state.bin");
		FingerprintViewStates(Views);
		const std::string Written = PackViewStates(Views);
		return PackViewStates(UnpackViewStates(Written, "again.bin")) == Written ? ""
																				 : "a state reads as something else";
	}
	catch (const FError& Error)
	{
		const std::vector<FDiagnostic>& Found = Error.GetDiagnostics();
		const bool bOne = Found.size() == 1 && Found[0].Code == ErrorStateBroken && Error.GetExitCode() == ExitFiles;
		return bOne ? "" : std::string("not one message about a state: ") + Error.what();
	}
}

inline std::string CheckViewStateBytes(const std::string& Bytes)
{
	std::string Problem = CheckSealedViewState(Bytes);
	if (Problem.empty())
	{
		Problem = CheckSealedViewState(SealViewState(Bytes));
	}
	GRenderTargetPool.FreeUnusedResources();
	GRenderGraphResourcePool.FreeUnusedResources();
	return Problem;
}

} // namespace Drydock
