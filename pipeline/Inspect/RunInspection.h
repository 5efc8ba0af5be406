// Inspects the shaders of a run as asked, and holds the answers: findings, pictures, printed lines.
#pragma once

#include "DispatchObserver.h"
#include "Inspect/CheckCapture.h"
#include "Inspect/DebugCapture.h"
#include "Inspect/LineCapture.h"
#include "Inspect/PrintCapture.h"

#include <filesystem>

namespace Drydock
{

struct FInspectOptions
{
	std::vector<std::string> Checks; // names, of what shaders do wrong
	std::vector<std::string> Show;   // "X.usf:41", "X.usf:41:Weight"
	bool bCoverage = false;
	bool bCost = false;
	bool bRanges = false;
	bool bAllThreads = false; // checks and ranges look at all threads, not at a sample
	bool bPrint = false;
	std::vector<int> PrintAt; // empty: every thread; else x, y
	std::optional<FDebugRequest> Debug;
	std::string Passes = "*"; // pattern, of a pass's name or its shader's

	bool IsEmpty() const
	{
		return Checks.empty() && Show.empty() && !bCoverage && !bCost && !bRanges && !bPrint && !Debug;
	}
};

/** The folder of a run's outputs that its pictures lie in. */
inline constexpr const char* InspectFolderName = "inspect";

class DRYDOCK_API FRunInspection final : public IDispatchObserver
{
public:
	/** Throws FError (DD1020) for names and places that are none. */
	explicit FRunInspection(const FInspectOptions& InOptions);
	~FRunInspection() override;

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;
	void AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** Whether nothing was asked for. */
	bool IsEmpty() const { return Options.IsEmpty(); }

	/** The findings of checks, requested prints that no shader made, and what a debugger does not get. */
	std::vector<FDiagnostic> GetDiagnostics() const;

	/** Writes pictures and lists into Folder/inspect, and returns a report on them, a line each. Throws FError: a place
	 * that gave no value (exit code 2), a file that cannot be written (3). */
	std::string Write(const std::filesystem::path& Folder, int Width = 0) const;

private:
	void WriteFindings(const std::filesystem::path& Folder) const;
	std::string WriteLines(const std::filesystem::path& Folder) const;
	std::string WriteCosts(const std::filesystem::path& Folder, int Width) const;
	std::string FormatRanges(int Width) const;
	std::string WriteCoverage(const std::filesystem::path& Folder) const;

	const FInspectOptions Options;
	FCheckCapture Checks;
	FLineCapture Lines;
	FPrintCapture Prints;
	std::unique_ptr<FDebugCapture> Debug;
};

} // namespace Drydock
