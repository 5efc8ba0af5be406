// The preprocessor of shaders: it resolves conditions, macros and includes before the front end sees the text, as the
// engine's own preprocessor does. The text rewritten for the CPU is then the text that the compiler would have read.
#pragma once

#include "Diagnostics.h"
#include "ShaderMacros.h"

#include <functional>
#include <set>
#include <utility>

namespace Drydock
{

/** A file as #include found it. */
struct FShaderInclude
{
	std::string Path;                  // virtual
	const std::string* Text = nullptr; // normalised; null when there is no such file, which has been reported
};

/** "A.ush" of the line `#include "A.ush"`; empty: the line has another directive or none, or names a macro. */
DRYDOCK_API std::string FindQuotedInclude(const std::string& Line);

class DRYDOCK_API FShaderPreprocessor
{
public:
	/** Target as it was written, and where. */
	using FFindInclude =
		std::function<FShaderInclude(const std::string& Target, const std::string& Includer, int Line)>;

	explicit FShaderPreprocessor(FFindInclude InFindInclude)
		: FindInclude(std::move(InFindInclude))
	{
	}

	void Define(const std::string& Name, const std::string& Value);

	/** Appends the preprocessed text of a file. A file with #pragma once is included once. */
	void Append(const std::string& Path, const std::string& FileText);

	/** One text without directives but `#line N "/Virtual/path"` at each seam and #pragma pack_matrix; without
	 * comments. A line is never moved. */
	const std::string& GetText() const { return Text; }

	const FShaderMacros& GetMacros() const { return Macros; }

	/** DD6002 for directives and macros that are wrong, DD6003 for includes that cannot be followed. */
	std::vector<FDiagnostic>& GetErrors() { return Errors; }

private:
	struct FCondition
	{
		int Line = 0;
		bool bActive = false; // the branch that is being read
		bool bTaken = false;  // a branch has been
		bool bOuter = false;  // what surrounds the #if is active
		bool bElse = false;
	};
	struct FLines;

	bool IsSpent() const { return bSpent || Macros.IsSpent(); }
	bool IsActive() const { return Conditions.empty() || Conditions.back().bActive; }
	void Error(int Code, const std::string& Message);
	void AppendDirective(const std::string& Name, const std::string& Rest);
	void AppendCondition(const std::string& Name, const std::string& Rest);
	void AppendInclude(const std::string& Rest);
	void AppendText(const std::string& Line, FLines& Lines);
	void Emit(const std::string& Line, int Number);

	FFindInclude FindInclude;
	FShaderMacros Macros;
	std::vector<FCondition> Conditions;
	std::vector<std::string> Open; // files being read
	std::set<std::string> Once;    // files that said #pragma once
	int NumIncludes = 0;
	bool bSpent = false;  // no more of the text is read
	std::string Path;     // the file being read
	int Number = 0;       // its line, the first of those that backslashes join
	std::string TextPath; // where the end of Text stands
	int TextNumber = 0;
	std::string Text;
	std::vector<FDiagnostic> Errors;
};

} // namespace Drydock
