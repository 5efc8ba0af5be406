// The list of the files that drydock wrote into a folder, which stands in that folder. Only by this list a later run
// knows which files it may replace and remove.
#pragma once

#include "DrydockAPI.h"

#include <filesystem>
#include <set>
#include <string>
#include <utility>

namespace Drydock
{

class DRYDOCK_API FFileList
{
public:
	/** The list that File holds; an empty one where there is no such file. Throws FError (DD5023, exit code 3) where it
	 * is cut short, changed, of another version, or has names that lead out of the folder. */
	static FFileList Read(const std::filesystem::path& File);

	/** All files in Folder and beneath it. Unsteady: names of those whose bytes differ from run to run, which are
	 * identified by their names alone, so that equal runs give equal lists. Throws FError (exit code 3) when one cannot
	 * be read.
	 * */
	static FFileList Make(const std::filesystem::path& Folder, const std::set<std::string>& Unsteady);

	/** One line for each file, and a fingerprint of them all. */
	std::string GetText() const;

	/** Name: its path from the folder, with '/'. Fingerprint: of its bytes (FingerprintFile), or empty. */
	void Add(const std::string& Name, const std::string& Fingerprint);
	/** Both lists: where names are in both, files like either are. */
	void Add(const FFileList& Other);
	/** Forgets what it has of this name. */
	void Remove(const std::string& Name);

	/** A call that was stopped while it replaced a file leaves the name twice: forgets the fingerprint that the file in
	 * Folder does not have. Returns whether it forgot one. */
	bool Settle(const std::filesystem::path& Folder);

	bool IsEmpty() const { return Files.empty(); }
	bool Has(const std::string& Name) const;
	/** Ascending, each once. */
	std::set<std::string> GetNames() const;

	/** The fault of the file of this name beneath Folder: "is missing", "is empty", "is not as it was written", "is not
	 * on the list", "is behind a symbolic link"; nothing where it is as the list has it. */
	std::string FindFault(const std::filesystem::path& Folder, const std::string& Name) const;

	/** The first entry of Folder/Sub that is not on the list, by its name: "passes/Bloom.cpp". Folders that hold only
	 * listed files do not count. Empty: there is no such entry. Names that are in Besides count as listed. */
	std::string FindForeign(
		const std::filesystem::path& Folder, const std::string& Sub, const std::set<std::string>& Besides = {}) const;

	bool operator==(const FFileList&) const = default;

private:
	std::set<std::pair<std::string, std::string>> Files; // name and fingerprint; a name twice while it is replaced
};

/** Removes the files of these names, then the folders beneath Folder that this leaves empty. Throws FError (exit code
 * 3). */
DRYDOCK_API void RemoveFiles(const std::filesystem::path& Folder, const std::set<std::string>& Names);

} // namespace Drydock
