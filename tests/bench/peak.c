/* peak COMMAND...: runs it and prints the most memory it held, in MB. */
#include <stdio.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

int main(int argc, char **argv)
{
    struct rusage used;
    int status;

    if (argc < 2)
        return 2;
    const pid_t child = fork();
    if (child == 0) {
        execvp(argv[1], argv + 1);
        _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || getrusage(RUSAGE_CHILDREN, &used))
        return 1;
    printf("%.1f\n", (double)used.ru_maxrss / 1024);     /* Linux counts kB */
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
