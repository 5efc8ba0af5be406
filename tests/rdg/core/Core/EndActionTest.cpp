// What is done when a process is told to end, in processes of their own: from there on they only wait.
#include <gtest/gtest.h>

#include "EndAction.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

class EndActions : public testing::Test
{
protected:
	EndActions()
		: Folder(Files::temp_directory_path() / ("drydock_end_" + std::to_string(getpid())))
	{
		Files::create_directories(Folder);
	}
	~EndActions() override { Files::remove_all(Folder); }

	/** Calls the function in a child, which ends then; its exit code. */
	template<typename TFunction>
	static int InAChild(const TFunction& Function)
	{
		const pid_t Child = fork();
		if (Child == 0)
		{
			Function();
			_exit(0);
		}
		int Status = 0;
		waitpid(Child, &Status, 0);
		return WIFEXITED(Status) ? WEXITSTATUS(Status) : -1;
	}

	const Files::path Folder;
};

} // namespace

TEST_F(EndActions, LatestComesFirstAndEndedOnesNotAtAll)
{
	const Files::path File = Folder / "order";
	const auto Note = [&](const char* Text)
	{
		return [&File, Text]
		{
			std::ofstream(File, std::ios::app) << Text;
		};
	};
	EXPECT_EQ(0, InAChild(
					 [&]
					 {
						 const FEndAction First(Note("1"));
						 {
							 const FEndAction Ended(Note("x"));
						 }
						 const FEndAction Second(Note("2"));
						 DoEndActions();
						 _exit(0);
					 }));
	std::ifstream Stream(File);
	EXPECT_EQ("21", std::string(std::istreambuf_iterator<char>(Stream), {}));
}
