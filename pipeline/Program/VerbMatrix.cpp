// `drydock matrix`: one plugin under every engine version, side by side.
#include "Matrix/Matrix.h"
#include "Matrix/MatrixSummary.h"
#include "Matrix/MatrixTable.h"
#include "Matrix/MatrixVersions.h"
#include "Program/FindingsOption.h"
#include "Program/ProgramOutput.h"
#include "Program/ProgressBar.h"
#include "Program/ReportOption.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Report/MatrixPage.h"
#include "Report/ReportPage.h"

#include <ctime>
#include <memory>

namespace Drydock
{

namespace
{

struct FMatrixOptions
{
	FMatrixRequest Request;
	std::string Versions; // of --versions
	bool bJson = false;
	std::string Report; // "on", "off"; empty: on where a person looks on
	FFindingsOptions Findings;
};

/** The rooms of tables and of pages know nothing of each other. */
FMatrixPageInputs GetMatrixPageInputs(const FVersionMatrix& Matrix)
{
	FMatrixPageInputs Inputs{Matrix.Name, MakeMatrixJson(Matrix), {}};
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		if (Row.Picture && (!Row.Picture->Before || Row.Picture->Difference))
		{
			Inputs.Pictures.push_back({DescribeVersion(Row.Minor), Row.Run->Folder + "/final.png"});
		}
	}
	return Inputs;
}

int MakeMatrix(const FMatrixOptions& Options, FJUnitSuite& Suite)
{
	FProgressBar Bar;
	FMatrixRequest Request = Options.Request;
	Request.Minors = ParseMatrixVersions(Options.Versions);
	Request.Progress = [&Bar](int Done, int Total, const std::string& What)
	{
		Bar.Show(Done, Total, What);
	};
	const bool bPage = WantsReport(Options.Report, Options.bJson);
	if (bPage)
	{
		Request.MakePage = [](const FVersionMatrix& Matrix)
		{
			return MakeReportPage(
				MakeMatrixPageData(GetMatrixPageInputs(Matrix), FormatReportTime(std::time(nullptr))));
		};
	}
	const FVersionMatrix Matrix = RunMatrix(Request);
	Bar.Clear();
	Suite.Name = Matrix.Name + " on " + (Matrix.bStockConfig ? "drydock's own small frame" : Matrix.Config);
	Suite.Cases = MakeMatrixCases(Matrix);
	PrintResult(Options.bJson ? MakeMatrixJson(Matrix)
							  : FormatMatrix(Matrix, GetOutputWidth()) +
									"pictures side by side: " + Matrix.OutputFolder + "/matrix.png\n",
		Options.bJson);
	if (bPage && !Options.bJson)
	{
		PrintPage(std::filesystem::path(Matrix.OutputFolder) / "matrix.html");
	}
	return GetMatrixExitCode(Matrix);
}

} // namespace

FVerbCall AddMatrixOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FMatrixOptions>();
	FMatrixRequest& Request = Options->Request;
	Verb.Add("PLUGIN_DIR", Request.Folder, "Folder of a plugin, with its .uplugin").Require();
	Verb.Add("CONFIG", Request.Config,
		"Run the plugin in this JSON config, which need not name it; in a small built-in frame by default");
	Verb.Add("--versions", Options->Versions, "Engine versions, such as 5.3-5.6,5.8; all known versions by default")
		.SetType("LIST");
	Verb.Add("--out", Request.OutputFolder,
			"Folder for builds, runs, matrix.txt, matrix.json and matrix.png; build/NAME-matrix by default")
		.SetType("DIR");
	Verb.AddRepeated("--exclude", "PATTERN", Request.Excludes,
		"Leave out a file, folder or module: a path relative to PLUGIN_DIR, or a name; with * and ?");
	Verb.Add("--compiler", Request.Compiler, "C++ compiler; CMake's choice by default").SetType("PATH");
	AddReport(Verb, Options->Report, "matrix.html, the table and the details of its cells");
	AddFindings(Verb, Options->Findings, "the cases builds, runs and picture for each version");
	Verb.AddFlag("--json", Options->bJson, "Print the table as JSON");
	return [Options]
	{
		return CallWithFindings(Options->Findings, "matrix", Options->Request.Folder,
			[&Options](FJUnitSuite& Suite) { return MakeMatrix(*Options, Suite); });
	};
}

} // namespace Drydock
