// A plugin that crashes under `drydock live`: the page is told, and the next edit goes on.
#include <gtest/gtest.h>

#include "LiveTestUtils.h"

#include <cstdlib>

using namespace LiveTest;

TEST(LiveCrash, IsAMessageAndTheNextEditGoesOn)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	GTEST_SKIP() << "a sanitizer ends the process in its own way";
#endif
	const FProgramFolder Folder("live_crash");
	Folder.WriteFrame("a.json", R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libCrashPlugin.so"])");
	setenv("DRYDOCK_TEST_CRASH", "write at pass", 1);
	setenv("DRYDOCK_TEST_CRASH_IF", "r.ToonBloom.AsPrinted", 1);
	FLiveProgram Program(Folder.Path, {"a.json"});
	unsetenv("DRYDOCK_TEST_CRASH");
	unsetenv("DRYDOCK_TEST_CRASH_IF");
	Program.WaitForFrame();
	EXPECT_EQ(200, Program.Edit("/camera/Settings/VignetteIntensity", 0.9).Status);
	const FJson Good = Program.WaitForFrame();
	ASSERT_TRUE(Good["fault"].is_null());
	const std::string Picture = Program.Get("/api/picture/now?kind=final8").Body;
	const std::string Start = Program.Get("/api/picture/start?kind=final8").Body;
	for (int Crash = 0; Crash < 3; ++Crash)
	{
		EXPECT_EQ(200, Program.Edit("/cvars/r.ToonBloom.AsPrinted", 1).Status);
		FJson Fault;
		for (int Try = 0; Try < 600 && (!Fault.is_object() || Fault["frame"].is_null()); ++Try)
		{
			std::this_thread::sleep_for(std::chrono::milliseconds(100));
			const FAnswer State = Program.Get("/api/state"); // none while it starts again
			Fault = State.Status == 200 && !State.Json()["fault"].is_null() ? State.Json() : FJson();
		}
		ASSERT_TRUE(Fault.is_object()) << Program.ReadLog();
		EXPECT_EQ("DD1123", Fault["fault"]["messages"][0]["code"]);
		const std::string Message = Fault["fault"]["messages"][0]["message"];
		EXPECT_NE(std::string::npos, Message.find("libCrashPlugin.so")) << Message;
		EXPECT_EQ(Picture, Program.Get("/api/picture/now?kind=final8").Body); // of the state before
		EXPECT_EQ(Start, Program.Get("/api/picture/start?kind=final8").Body);
		EXPECT_EQ(200, Program.Edit("/camera/Settings/BloomIntensity", 1 + Crash).Status);
		EXPECT_TRUE(Program.WaitForFrame()["fault"].is_null());
		EXPECT_EQ(200, Program.Change("undo").Status);
		Program.WaitForFrame();
	}
	EXPECT_EQ(200, Program.Post("/api/end").Status);
	EXPECT_EQ(0, Program.WaitForEnd());
}

TEST(LiveCrash, OfTheFirstFrameEndsTheProgramAsRunDoes)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	GTEST_SKIP() << "a sanitizer ends the process in its own way";
#endif
	const FProgramFolder Folder("live_crash_first");
	Folder.WriteFrame("a.json", R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libCrashPlugin.so"])");
	setenv("DRYDOCK_TEST_CRASH", "write at pass", 1);
	const FOutcome Outcome = Folder.Call("live a.json --no-open");
	unsetenv("DRYDOCK_TEST_CRASH");
	EXPECT_EQ(71, Outcome.ExitCode) << Outcome.Printed;
}
